#include "visibility/scene/scene.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_set>

namespace visibility {

namespace {

template <class Extend>
void for_each_bound(Scene const& s, Object const& o, Extend&& extend)
{
  for (auto i = o.boxes.first; i < o.boxes.last; ++i) extend(s.boxes[i]);
  for (auto i = o.balls.first; i < o.balls.last; ++i) extend(bounding_box(s.balls[i]));
  for (auto i = o.prisms.first; i < o.prisms.last; ++i) extend(bounding_box(s.prisms[i]));
  for (auto i = o.polyhedra.first; i < o.polyhedra.last; ++i) extend(bounding_box(s.polyhedra[i]));
  for (auto i = o.triangles.first; i < o.triangles.last; ++i) extend(bounding_box(s.triangle(i)));
}

}  // namespace

Box bounding_box(Scene const& scene, Object const& object)
{
  Box b;
  for_each_bound(scene, object, [&](Box const& x) { b.extend(x); });
  return b;
}

Box bounding_box(Scene const& scene)
{
  Box b;
  for (auto const& o : scene.objects) b.extend(bounding_box(scene, o));
  return b;
}

void Scene::validate() const
{
  auto const require = [](bool ok, char const* what) {
    if (!ok) throw std::logic_error(std::string("Scene: ") + what);
  };
  require(!objects.empty(), "no objects");
  std::unordered_set<std::string_view> names;
  Object expected;
  auto const tiles = [&](IndexRange const& r, IndexRange& previous) {
    bool const ok = r.first == previous.last && r.first <= r.last;
    previous = r;
    return ok;
  };
  for (auto const& o : objects) {
    require(names.insert(o.name).second, "two objects share a name");
    require(tiles(o.boxes, expected.boxes) && tiles(o.balls, expected.balls) && tiles(o.prisms, expected.prisms) &&
              tiles(o.polyhedra, expected.polyhedra) && tiles(o.triangles, expected.triangles),
            "primitive ranges do not tile the arrays");
  }
  require(expected.boxes.last == boxes.size() && expected.balls.last == balls.size() &&
            expected.prisms.last == prisms.size() && expected.polyhedra.last == polyhedra.size() &&
            expected.triangles.last == triangles.size(),
          "primitives without an object");
  require(std::ranges::all_of(vertices, [](Point3d const& v) { return is_finite(v); }), "a vertex is not finite");
  for (auto const& t : triangles)
    require(std::ranges::all_of(t, [&](auto i) { return i < vertices.size(); }), "a triangle index out of range");
  for (auto const& b : boxes)
    require(is_finite(b.min) && is_finite(b.max) && !b.is_empty(), "a box that is not finite and ordered");
  for (auto const& b : balls)
    require(is_finite(b.centre) && std::isfinite(b.radius) && b.radius >= 0, "a ball that is not finite");
  for (auto const& p : prisms) require(!p.rings.empty() && p.bottom < p.top, "a prism without ring or height");
  for (auto const& p : polyhedra) p.validate();
}

}  // namespace visibility
