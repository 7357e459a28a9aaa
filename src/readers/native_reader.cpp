// visibility-scene/1, the library's own format; docs/readers.md describes it.
#include "numbers.hpp"
#include "readers.hpp"

#include <cmath>

namespace visibility::readers {

namespace {

class NativeReader {
public:
  explicit NativeReader(std::string const& source) : source_(source), builder_(source) {}

  Scene read(JsonValue const& document)
  {
    if (document.text("format") != "visibility-scene/1")
      fail(source_, {},
           "unknown format '" + std::string(document.text("format")) + "'; this version reads visibility-scene/1");
    auto const vertices = numbers(document.find("vertices"), 3, "vertices");
    for (std::size_t i = 0; i < vertices.size(); i += 3)
      builder_.add_vertex({vertices[i], vertices[i + 1], vertices[i + 2]});
    vertex_count_ = vertices.size() / 3;
    for (auto const& note : document.list("notes"))
      if (auto const* text = note.as_string()) builder_.note(*text);
    for (auto const& object : document.list("objects")) read_object(object);
    return builder_.finish();
  }

private:
  [[noreturn]] void bad(std::string const& what) const
  {
    fail(source_, objects_ == 0 ? std::string() : "object " + std::to_string(objects_) + " '" + name_ + "'", what);
  }

  /// A flat list of numbers, `arity` to each item. Absent: empty.
  std::vector<double> numbers(JsonValue const* list, std::size_t arity, std::string const& what) const
  {
    std::vector<double> out;
    if (list == nullptr) return out;
    auto const* items = list->as_array();
    if (items == nullptr || items->size() % arity != 0)
      bad("'" + what + "' must be a flat list of numbers, " + std::to_string(arity) + " for each");
    out.reserve(items->size());
    for (auto const& item : *items) {
      auto const number = item.as_number();
      if (!number || !std::isfinite(*number)) bad("'" + what + "' must be finite numbers");
      out.push_back(*number);
    }
    return out;
  }

  std::vector<std::uint32_t> indices(JsonValue const* list, std::size_t count, std::string const& what) const
  {
    std::vector<std::uint32_t> out;
    for (double const i : numbers(list, 3, what)) {
      if (!(i >= 0 && i < static_cast<double>(count)) || i != std::floor(i))
        bad("'" + what + "' names vertex " + shortest(i) + ", but there are " + std::to_string(count));
      out.push_back(static_cast<std::uint32_t>(i));
    }
    return out;
  }

  void read_object(JsonValue const& object)
  {
    ++objects_;
    name_ = object.text("name").empty() ? "object " + std::to_string(objects_) : object.text("name");
    if (object.as_object() == nullptr) bad("is not an object");
    for (auto const& [key, value] : *object.as_object())
      if (key != "name" && key != "boxes" && key != "balls" && key != "prisms" && key != "polyhedra" &&
          key != "triangles")
        bad("unknown kind '" + key + "' (boxes, balls, prisms, polyhedra and triangles are known)");
    builder_.begin_object(name_);
    auto const boxes = numbers(object.find("boxes"), 6, "boxes");
    for (auto b = boxes.begin(); b != boxes.end(); b += 6) builder_.add(Box{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}});
    auto const balls = numbers(object.find("balls"), 4, "balls");
    for (auto b = balls.begin(); b != balls.end(); b += 4) builder_.add(Ball{{b[0], b[1], b[2]}, b[3]});
    for (auto const& p : object.list("prisms")) builder_.add(read_prism(p));
    for (auto const& p : object.list("polyhedra")) builder_.add(read_polyhedron(p));
    auto const t = indices(object.find("triangles"), vertex_count_, "triangles");
    for (std::size_t i = 0; i < t.size(); i += 3) builder_.add_triangle(t[i], t[i + 1], t[i + 2]);
  }

  Prism read_prism(JsonValue const& value) const
  {
    auto const* bottom = value.find("bottom");
    auto const* top = value.find("top");
    auto const low = bottom == nullptr ? std::nullopt : bottom->as_number();
    auto const high = top == nullptr ? std::nullopt : top->as_number();
    if (!low || !high) bad("a prism needs numbers 'bottom' and 'top'");
    Prism p{{}, *low, *high};
    for (auto const& ring : value.list("rings")) {
      auto const c = numbers(&ring, 2, "rings");
      auto& out = p.rings.emplace_back();
      for (std::size_t i = 0; i < c.size(); i += 2) out.push_back({c[i], c[i + 1]});
    }
    return p;
  }

  ConvexPolyhedron read_polyhedron(JsonValue const& value) const
  {
    auto const c = numbers(value.find("vertices"), 3, "polyhedra vertices");
    std::vector<Point3d> vertices;
    for (std::size_t i = 0; i < c.size(); i += 3) vertices.push_back({c[i], c[i + 1], c[i + 2]});
    auto const t = indices(value.find("facets"), vertices.size(), "polyhedra facets");
    std::vector<std::array<std::uint32_t, 3>> facets;
    for (std::size_t i = 0; i < t.size(); i += 3) facets.push_back({t[i], t[i + 1], t[i + 2]});
    try {
      return ConvexPolyhedron::from_facets(std::move(vertices), facets);
    } catch (std::invalid_argument const& e) {
      bad(std::string("a polyhedron is not convex and closed: ") + e.what());
    }
  }

  std::string source_;
  SceneBuilder builder_;
  std::size_t vertex_count_ = 0, objects_ = 0;
  std::string name_;
};

}  // namespace

Scene read_native(JsonValue const& document, std::string const& source) { return NativeReader(source).read(document); }

}  // namespace visibility::readers
