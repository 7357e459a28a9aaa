#include "cityjson_geometry.hpp"

#include "decimal.hpp"
#include "numbers.hpp"
#include "readers.hpp"

#include <algorithm>

namespace visibility::readers {

namespace {

std::string object_place(std::string const& object) { return "object '" + object + "'"; }

/// The transform of one axis.
DecimalTransform axis_transform(JsonValue const& transform, std::size_t axis, std::string const& source)
{
  auto const part = [&](char const* key) {
    auto const& list = transform.list(key);
    auto const d =
      list.size() == 3 && list[axis].as_number() ? Decimal::parse(list[axis].decimal_text()) : std::nullopt;
    if (!d) fail(source, "transform", std::string("'") + key + "' must be three numbers of ordinary size");
    return *d;
  };
  return {part("scale"), part("translate")};
}

double coordinate(JsonValue const& value, DecimalTransform const* transform, std::string const& source,
                  std::string const& where)
{
  auto const number = value.as_number();
  if (!number) fail(source, where, "a vertex must be three numbers");
  double result = *number;
  if (transform != nullptr) {
    constexpr double exact_limit = 0x1p53;
    if (std::fabs(*number) <= exact_limit && *number == std::floor(*number))
      result = (*transform)(static_cast<std::int64_t>(*number));
    else if (auto const decimal = Decimal::parse(value.decimal_text()))
      result = (*transform)(*decimal);
    else
      fail(source, where, "a coordinate is out of range");
  }
  if (!std::isfinite(result)) fail(source, where, "a coordinate is not finite");
  return result;
}

std::vector<Point3d> read_points(JsonValue::Array const& list, std::array<DecimalTransform, 3> const* transform,
                                 std::string const& source, std::string const& where)
{
  std::vector<Point3d> points;
  points.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto const* p = list[i].as_array();
    auto const place = [&] { return where + "vertex " + std::to_string(i); };
    if (p == nullptr || p->size() != 3) fail(source, place(), "a vertex must be three numbers");
    auto const at = [&](std::size_t axis) {
      auto const* t = transform == nullptr ? nullptr : &(*transform)[axis];
      auto const number = (*p)[axis].as_number();
      // Decimals that a double holds wholly are the rule; messages are made only when needed.
      if (number && t == nullptr && std::isfinite(*number)) return *number;
      if (number && t != nullptr && std::fabs(*number) <= 0x1p53 && *number == std::floor(*number))
        if (double const x = (*t)(static_cast<std::int64_t>(*number)); std::isfinite(x)) return x;
      return coordinate((*p)[axis], t, source, place());
    };
    points.push_back({at(0), at(1), at(2)});
  }
  return points;
}

}  // namespace

std::vector<Point3d> CityJsonVertices::read(JsonValue const& document, JsonValue const* transform,
                                            std::string const& source, std::string const& where)
{
  auto const* vertices = document.find("vertices");
  if (vertices == nullptr || vertices->as_array() == nullptr)
    fail(source, where.empty() ? where : where.substr(0, where.size() - 2),
         "has no list 'vertices'; is the file complete?");
  if (transform == nullptr || transform->is_null()) return read_points(*vertices->as_array(), nullptr, source, where);
  std::array<DecimalTransform, 3> const axes{axis_transform(*transform, 0, source),
                                             axis_transform(*transform, 1, source),
                                             axis_transform(*transform, 2, source)};
  return read_points(*vertices->as_array(), &axes, source, where);
}

CityJsonTemplates CityJsonTemplates::read(JsonValue const& document, std::string const& source)
{
  CityJsonTemplates out;
  auto const* templates = document.find("geometry-templates");
  if (templates == nullptr) return out;
  for (auto const& g : templates->list("templates")) out.geometries.push_back(&g);
  out.vertices = read_points(templates->list("vertices-templates"), nullptr, source, "geometry-templates, ");
  return out;
}

double level_of_detail(JsonValue const& geometry)
{
  auto const* lod = geometry.find("lod");
  if (lod == nullptr) return 1;
  if (auto const number = lod->as_number()) return *number;
  if (auto const* text = lod->as_string())
    if (auto const number = parse_double(*text)) return *number;
  return 1;
}

void CityJsonSurfaces::add(JsonValue const& geometry, std::vector<Point3d> const& vertices,
                           CityJsonTemplates const& templates, std::string const& object)
{
  auto const type = geometry.text("type");
  if (type == "GeometryInstance") return add_instance(geometry, vertices, templates, object);
  int const depth = type == "MultiSurface" || type == "CompositeSurface" ? 1
                    : type == "Solid"                                    ? 2
                    : type == "MultiSolid" || type == "CompositeSolid"   ? 3
                                                                         : 0;
  auto const* boundaries = geometry.find("boundaries");
  if (depth == 0) {
    ++unknown_;
    return;
  }
  if (boundaries == nullptr || boundaries->is_null()) return;
  add_nested(*boundaries, depth, vertices, object);
}

void CityJsonSurfaces::add_nested(JsonValue const& boundaries, int depth, std::vector<Point3d> const& vertices,
                                  std::string const& object)
{
  if (boundaries.as_array() == nullptr)
    fail(source_, object_place(object), "boundaries must be nested lists of vertex numbers");
  for (auto const& part : *boundaries.as_array())
    if (depth > 1)
      add_nested(part, depth - 1, vertices, object);
    else
      add_surface(part, vertices, object);
}

void CityJsonSurfaces::add_surface(JsonValue const& surface, std::vector<Point3d> const& vertices,
                                   std::string const& object)
{
  if (surface.as_array() == nullptr) fail(source_, object_place(object), "a surface must be a list of rings");
  rings_.clear();
  for (auto const& ring : *surface.as_array()) {
    if (ring.as_array() == nullptr) fail(source_, object_place(object), "a ring must be a list of vertex numbers");
    auto& out = rings_.emplace_back();
    for (auto const& corner : *ring.as_array()) {
      auto const i = corner.as_number();
      if (!i || !(*i >= 0) || !(*i < static_cast<double>(vertices.size())) || *i != std::floor(*i))
        fail(source_, object_place(object),
             "a ring names vertex " + (i ? shortest(*i) : "that is no number") + ", but there are " +
               std::to_string(vertices.size()));
      out.push_back(static_cast<VertexIndex>(*i));
    }
    drop_repeats(vertices, out);
    // A hole without area hides nothing and opens nothing.
    if (rings_.size() > 1 && out.size() < 3) rings_.pop_back();
  }
  if (rings_.empty()) return dropped_.count(Triangulated::no_area);
  triangles_.clear();
  dropped_.count(triangulate(vertices, rings_, triangles_));
  for (auto const& t : triangles_) {
    std::array<VertexIndex, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = scene_vertex(t[i], vertices);
    builder_.add_triangle(v[0], v[1], v[2]);
  }
}

VertexIndex CityJsonSurfaces::scene_vertex(VertexIndex i, std::vector<Point3d> const& vertices)
{
  constexpr auto none = ~VertexIndex{0};
  if (scene_index_.size() < vertices.size()) scene_index_.resize(vertices.size(), none);
  if (scene_index_[i] == none) scene_index_[i] = builder_.add_vertex(vertices[i]);
  return scene_index_[i];
}

void CityJsonSurfaces::add_instance(JsonValue const& geometry, std::vector<Point3d> const& vertices,
                                    CityJsonTemplates const& templates, std::string const& object)
{
  auto const place = object_place(object);
  auto const* which = geometry.find("template");
  auto const index = which == nullptr ? std::nullopt : which->as_number();
  if (!index || !(*index >= 0) || !(*index < static_cast<double>(templates.geometries.size())))
    fail(source_, place, "names a geometry template that the file does not have");
  auto const& shape = *templates.geometries[static_cast<std::size_t>(*index)];
  if (shape.text("type") == "GeometryInstance")
    fail(source_, place, "a geometry template must not be an instance itself");

  auto const& anchor = geometry.list("boundaries");
  auto const at = anchor.size() == 1 ? anchor[0].as_number() : std::nullopt;
  if (!at || !(*at >= 0) || !(*at < static_cast<double>(vertices.size())))
    fail(source_, place, "an instance must name one vertex, its anchor");
  auto const& origin = vertices[static_cast<std::size_t>(*at)];
  std::array<double, 16> m{};
  auto const& matrix = geometry.list("transformationMatrix");
  if (matrix.size() != 16) fail(source_, place, "'transformationMatrix' must be 16 numbers");
  for (std::size_t i = 0; i < 16; ++i) {
    auto const number = matrix[i].as_number();
    if (!number) fail(source_, place, "'transformationMatrix' must be 16 numbers");
    m[i] = *number;
  }
  // Rounded here, once per vertex: an instance has no exact coordinates of its own. The doubles are the input.
  std::vector<Point3d> placed;
  placed.reserve(templates.vertices.size());
  for (auto const& p : templates.vertices) {
    auto const row = [&](std::size_t r) { return m[r] * p.x + m[r + 1] * p.y + m[r + 2] * p.z + m[r + 3]; };
    Point3d const q{row(0) + origin.x, row(4) + origin.y, row(8) + origin.z};
    if (!is_finite(q)) fail(source_, place, "an instance has a coordinate that is not finite");
    placed.push_back(q);
  }
  std::vector<VertexIndex> own;
  std::swap(own, scene_index_);
  add(shape, placed, templates, object);
  std::swap(own, scene_index_);
}

void CityJsonSurfaces::note() const
{
  dropped_.note(builder_);
  if (unknown_ > 0)
    builder_.note(std::to_string(unknown_) + " geometries that are neither surfaces nor solids left out");
}

}  // namespace visibility::readers
