#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace visibility {

namespace {

/// Length of the UTF-8 sequence at the start of s, 0 if it is malformed or a control character.
std::size_t printable_sequence(std::string_view s)
{
  auto const byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  std::size_t const n = byte(0) < 0x80   ? 1
                        : byte(0) < 0xC2 ? 0
                        : byte(0) < 0xE0 ? 2
                        : byte(0) < 0xF0 ? 3
                        : byte(0) < 0xF5 ? 4
                                         : 0;
  if (n == 1) return byte(0) >= 0x20 && byte(0) != 0x7F ? 1 : 0;
  if (n == 0 || n > s.size()) return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  bool const overlong = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xF0 && byte(1) < 0x90);
  bool const outside = (byte(0) == 0xED && byte(1) > 0x9F) || (byte(0) == 0xF4 && byte(1) > 0x8F);
  return overlong || outside ? 0 : n;
}

/// The name with what cannot stand in a JSON string or on one line replaced by '?'.
std::string printable(std::string_view name)
{
  std::string out;
  while (!name.empty()) {
    std::size_t const n = printable_sequence(name);
    if (n == 0)
      out += '?';
    else
      out += name.substr(0, n);
    name.remove_prefix(n == 0 ? 1 : n);
  }
  return out;
}

}  // namespace

SceneBuilder::SceneBuilder(std::string source) { scene_.source = std::move(source); }

void SceneBuilder::fail(std::string const& what) const
{
  std::string const object = scene_.objects.empty() ? "" : ", object '" + scene_.objects.back().name + "'";
  throw BadInput(scene_.source + object + ": " + what);
}

Object& SceneBuilder::current()
{
  if (scene_.objects.empty()) begin_object("object");
  return scene_.objects.back();
}

void SceneBuilder::begin_object(std::string_view name)
{
  Object o;
  o.name = printable(name);
  auto const at = [](auto const& array) {
    auto const n = static_cast<std::uint32_t>(array.size());
    return IndexRange{n, n};
  };
  o.boxes = at(scene_.boxes);
  o.balls = at(scene_.balls);
  o.prisms = at(scene_.prisms);
  o.polyhedra = at(scene_.polyhedra);
  o.triangles = at(scene_.triangles);
  scene_.objects.push_back(std::move(o));
}

void SceneBuilder::begin_occludee(std::string_view name)
{
  begin_object(name);
  scene_.objects.back().occludes = false;
}

void SceneBuilder::add(Box const& box)
{
  auto& o = current();
  if (!is_finite(box.min) || !is_finite(box.max)) fail("a box coordinate is not finite");
  if (box.is_empty()) fail("a box has min > max");
  scene_.boxes.push_back(box);
  ++o.boxes.last;
}

void SceneBuilder::add(Ball const& ball)
{
  auto& o = current();
  if (!is_finite(ball.centre) || !std::isfinite(ball.radius)) fail("a ball is not finite");
  if (ball.radius < 0) fail("a ball has a negative radius");
  scene_.balls.push_back(ball);
  ++o.balls.last;
}

void SceneBuilder::add(Prism prism)
{
  auto& o = current();
  if (!std::isfinite(prism.bottom) || !std::isfinite(prism.top)) fail("a height is not finite");
  if (!(prism.bottom < prism.top)) fail("a prism has no height (top must lie above bottom)");
  if (prism.rings.empty() || prism.rings.front().size() < 3) fail("a footprint has fewer than three points");
  for (auto const& ring : prism.rings)
    if (!std::ranges::all_of(ring, [](Point2d const& p) { return is_finite(p); }))
      fail("a footprint coordinate is not finite");
  scene_.prisms.push_back(std::move(prism));
  ++o.prisms.last;
}

void SceneBuilder::add(ConvexPolyhedron polyhedron)
{
  auto& o = current();
  scene_.polyhedra.push_back(std::move(polyhedron));
  ++o.polyhedra.last;
}

std::uint32_t SceneBuilder::add_vertex(Point3d const& p)
{
  if (!is_finite(p)) fail("a vertex coordinate is not finite");
  if (scene_.vertices.size() >= UINT32_MAX) fail("more than 2^32 vertices");
  scene_.vertices.push_back(p);
  return static_cast<std::uint32_t>(scene_.vertices.size() - 1);
}

void SceneBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  auto& o = current();
  if (std::max({a, b, c}) >= scene_.vertices.size()) fail("a triangle names a vertex that does not exist");
  if (scene_.triangles.size() >= UINT32_MAX) fail("more than 2^32 triangles");
  scene_.triangles.push_back({a, b, c});
  ++o.triangles.last;
}

void SceneBuilder::note(std::string text) { scene_.notes.push_back(std::move(text)); }

Scene SceneBuilder::finish()
{
  auto const empty = [](Object const& o) {
    return o.boxes.size() + o.balls.size() + o.prisms.size() + o.polyhedra.size() + o.triangles.size() == 0;
  };
  if (auto const dropped = std::erase_if(scene_.objects, empty); dropped > 0)
    note(std::to_string(dropped) + " objects without geometry dropped");
  if (scene_.objects.empty()) throw BadInput(scene_.source + ": no objects with geometry");

  std::unordered_set<std::string> taken;
  for (auto const& o : scene_.objects) taken.insert(o.name);
  if (taken.size() < scene_.objects.size()) {
    std::unordered_map<std::string, int> uses;
    for (auto& o : scene_.objects) {
      int& n = uses[o.name];
      if (n++ == 0) continue;
      std::string const base = o.name;
      do o.name = base + "#" + std::to_string(n++);
      while (!taken.insert(o.name).second);
      --n;
    }
  }
  return std::exchange(scene_, {});
}

}  // namespace visibility
