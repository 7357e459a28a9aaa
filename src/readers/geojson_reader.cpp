// GeoJSON [RFC 7946] and GeoJSONSeq [RFC 8142] footprints: each feature an object of vertical prisms.
#include "geojson_heights.hpp"
#include "geojson_projection.hpp"
#include "numbers.hpp"
#include "readers.hpp"

#include <algorithm>
#include <cmath>

namespace visibility::readers {

namespace {

constexpr std::string_view name_properties[] = {"id",   "ID",   "@id",    "name",   "Name",
                                                "NAME", "bldg", "osm_id", "gml_id", "fid"};

class GeoJsonReader {
public:
  GeoJsonReader(std::string const& source, ReadOptions const& options)
    : source_(source), options_(options), heights_(options)
  {
  }

  /// A FeatureCollection, a Feature or a bare geometry.
  void document(JsonValue const& value, std::size_t line)
  {
    line_ = line;
    auto const type = value.text("type");
    reference_system(value);
    if (type == "FeatureCollection") {
      auto const* features = value.find("features");
      if (features == nullptr || features->as_array() == nullptr)
        fail(source_, "line " + std::to_string(line),
             "a FeatureCollection without a list 'features'; is the file complete?");
      in_collection_ = true;
      for (auto const& f : *features->as_array()) feature(f);
    } else if (type == "Feature") {
      feature(value);
    } else {
      bad("a Feature or FeatureCollection was expected, not type '" + std::string(type) + "'");
    }
  }

  Scene finish()
  {
    if (prisms_.empty() && without_height_ > 0) no_heights();
    SceneBuilder builder(source_);
    settle_grounds(builder);
    if (are_degrees(prisms_, system_, options_.coordinates)) {
      check_degrees();
      builder.note(project(prisms_));
    } else
      builder.note("coordinates taken as metres");
    builder.note(heights_.used());
    notes(builder);
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      builder.begin_object(std::move(objects_[i].name));
      auto const last = i + 1 < objects_.size() ? objects_[i + 1].first : prisms_.size();
      for (auto p = objects_[i].first; p < last; ++p)
        if (prisms_[p].bottom < prisms_[p].top) builder.add(std::move(prisms_[p]));
    }
    return builder.finish();
  }

private:
  struct NamedObject {
    std::string name;
    std::size_t first;  // of its prisms
  };
  /// What the z coordinates of a footprint say, kept until it is known what they mean.
  struct Elevation {
    double height;
    std::optional<FootprintHeights::Ground> ground;
    std::optional<double> z;  // the lowest
  };

  std::string place() const
  {
    auto const feature = "feature " + std::to_string(features_);
    return in_collection_ ? feature : "line " + std::to_string(line_) + ", " + feature;
  }
  [[noreturn]] void bad(std::string const& what) const { fail(source_, place(), what); }

  void reference_system(JsonValue const& value)
  {
    auto const* crs = value.find("crs");
    if (crs == nullptr || crs->is_null()) return;
    auto const* properties = crs->find("properties");
    system_name_ = properties == nullptr ? std::string_view() : properties->text("name");
    system_ = classify_reference_system(system_name_);
  }

  void feature(JsonValue const& f)
  {
    ++features_;
    if (f.text("type") != "Feature") bad("is no Feature (its type is '" + std::string(f.text("type")) + "')");
    auto const* geometry = f.find("geometry");
    if (geometry == nullptr || geometry->is_null()) {
      ++without_geometry_;
      return;
    }
    auto const type = geometry->text("type");
    auto const* coordinates = geometry->find("coordinates");
    if (type != "Polygon" && type != "MultiPolygon") {
      if (type.empty()) bad("its geometry has no type");
      ++not_polygons_;
      return;
    }
    if (coordinates == nullptr || coordinates->as_array() == nullptr) bad("its geometry has no coordinates");
    static JsonValue const none;
    auto const* properties = f.find("properties");
    if (properties == nullptr) properties = &none;
    auto const height = heights_.height(*properties);
    auto const ground = heights_.ground(*properties);
    Elevation const elevation{height.value_or(0), ground, {}};

    auto const first = prisms_.size();
    if (type == "Polygon")
      polygon(*coordinates, elevation);
    else
      for (auto const& p : *coordinates->as_array()) polygon(p, elevation);
    if (prisms_.size() == first) return;
    if (!height) {
      ++without_height_;
      prisms_.resize(first);
      elevations_.resize(first);
      return;
    }
    objects_.push_back({name(f, *properties), first});
  }

  std::string name(JsonValue const& f, JsonValue const& properties) const
  {
    auto const text = [](JsonValue const* v) -> std::string {
      if (v == nullptr) return {};
      if (auto const* s = v->as_string()) return printable(*s);
      return v->as_number() ? v->decimal_text() : std::string();
    };
    if (auto const id = text(f.find("id")); !id.empty()) return id;
    for (auto const key : name_properties)
      if (auto const id = text(properties.find(key)); !id.empty()) return id;
    return "feature " + std::to_string(features_);
  }

  void polygon(JsonValue const& rings, Elevation elevation)
  {
    if (rings.as_array() == nullptr) bad("a polygon must be a list of rings");
    Prism prism;
    for (std::size_t i = 0; i < rings.as_array()->size(); ++i) {
      auto ring = read_ring((*rings.as_array())[i], elevation.z);
      if (ring.size() >= 3) {
        prism.rings.push_back(std::move(ring));
        continue;
      }
      ++short_rings_;
      if (i == 0) return;  // without its outer ring the polygon is nothing; a hole without area opens nothing
    }
    if (prism.rings.empty()) return;
    prisms_.push_back(std::move(prism));
    elevations_.push_back(elevation);
  }

  /// Distinct consecutive points, open.
  std::vector<Point2d> read_ring(JsonValue const& list, std::optional<double>& lowest) const
  {
    if (list.as_array() == nullptr) bad("a ring must be a list of positions");
    std::vector<Point2d> ring;
    ring.reserve(list.as_array()->size());
    for (auto const& position : *list.as_array()) {
      auto const* c = position.as_array();
      if (c == nullptr || c->size() < 2) bad("a position must be two or three numbers");
      auto const x = (*c)[0].as_number(), y = (*c)[1].as_number();
      if (!x || !y) bad("a position must be two or three numbers");
      if (c->size() > 2)
        if (auto const z = (*c)[2].as_number()) lowest = lowest ? std::min(*lowest, *z) : *z;
      Point2d const p{*x, *y};
      if (ring.empty() || ring.back() != p) ring.push_back(p);
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
  }

  /// Bottom and top of each prism. Where a file gives the ground of most footprints but not of all, their z coordinates
  /// fill in: what they mean (roof, as in BD TOPO, or ground) is seen from the footprints that have both.
  void settle_grounds(SceneBuilder& builder)
  {
    std::size_t at_roof = 0, at_ground = 0, from_z = 0, at_zero = 0, no_room = 0;
    bool any_ground = false;
    for (auto const& e : elevations_) {
      any_ground = any_ground || e.ground.has_value();
      if (!e.ground || !e.z) continue;
      double const top = e.ground->elevation + e.height;
      (std::fabs(*e.z - top) < std::fabs(*e.z - e.ground->elevation) ? at_roof : at_ground) += 1;
    }
    for (std::size_t i = 0; i < prisms_.size(); ++i) {
      auto const& e = elevations_[i];
      auto& p = prisms_[i];
      if (e.ground) {
        p.bottom = e.ground->elevation;
        p.top = e.ground->height_starts_here ? p.bottom + e.height : e.height;
      } else if (any_ground && e.z) {
        bool const is_roof = at_roof > at_ground;
        p.bottom = is_roof ? *e.z - e.height : *e.z;
        p.top = is_roof ? *e.z : *e.z + e.height;
        ++from_z;
      } else {
        p.bottom = 0;
        p.top = e.height;
        at_zero += any_ground;
      }
      if (!std::isfinite(p.bottom) || !std::isfinite(p.top))
        fail(source_, "object '" + object_of(i) + "'", "ground plus height is beyond the range of double");
      no_room += !(p.bottom < p.top);
    }
    if (from_z > 0)
      builder.note(std::to_string(from_z) + " footprints without ground: taken from their z coordinate (" +
                   (at_roof > at_ground ? "a roof" : "a ground") + " in this file)");
    if (at_zero > 0) builder.note(std::to_string(at_zero) + " footprints without ground put at 0");
    if (no_room > 0) builder.note(std::to_string(no_room) + " footprints whose top is not above their ground left out");
  }

  std::string const& object_of(std::size_t prism) const
  {
    auto const it = std::ranges::upper_bound(objects_, prism, {}, &NamedObject::first);
    return std::prev(it)->name;
  }

  /// Requires degrees: throws where a wrong option or reference system shows.
  void check_degrees() const
  {
    for (std::size_t i = 0; i < prisms_.size(); ++i)
      for (auto const& ring : prisms_[i].rings)
        for (auto const& v : ring)
          if (!(std::fabs(v.x) <= 360 && std::fabs(v.y) <= 90))
            fail(source_, "object '" + object_of(i) + "'",
                 "a position is no longitude and latitude: " + shortest(v.x) + ", " + shortest(v.y) +
                   "; read it as metres");
  }

  void notes(SceneBuilder& builder) const
  {
    auto const count = [&](std::size_t n, char const* what) {
      if (n > 0) builder.note(std::to_string(n) + what);
    };
    count(heights_.from_levels(), " heights are storeys of 3 m");
    count(without_height_, " features without a height left out");
    count(without_geometry_, " features without geometry left out");
    count(not_polygons_, " features that are no polygons left out");
    count(short_rings_, " rings with fewer than three points left out");
  }

  [[noreturn]] void no_heights() const
  {
    auto const& wanted = options_.height_property;
    fail(source_, {},
         (wanted.empty() ? "no feature has a height" : "no feature has a height in property '" + wanted + "'") +
           "; name the property that holds it (properties seen: " + heights_.seen() + ")");
  }

  std::string source_;
  ReadOptions const& options_;
  FootprintHeights heights_;
  std::size_t line_ = 1, features_ = 0;
  bool in_collection_ = false;
  std::string system_name_;
  ReferenceSystem system_ = ReferenceSystem::none;
  std::vector<NamedObject> objects_;
  std::vector<Prism> prisms_;
  std::vector<Elevation> elevations_;
  std::size_t without_height_ = 0, without_geometry_ = 0, not_polygons_ = 0, short_rings_ = 0;
};

}  // namespace

Scene read_geojson(JsonValue first, JsonStream& stream, ReadOptions const& options)
{
  GeoJsonReader reader(stream.source(), options);
  reader.document(first, stream.line());
  first = {};
  while (auto const next = stream.next()) reader.document(*next, stream.line());
  return reader.finish();
}

}  // namespace visibility::readers
