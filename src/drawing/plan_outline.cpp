#include "visibility/drawing/plan_outline.hpp"

#include "mesh_outline.hpp"
#include "scene/plan.hpp"

#include <algorithm>

namespace visibility {

namespace {

/// The hull; of points on a line its two ends, of one point that point.
std::vector<Point2d> hull(std::vector<Point2d> const& points)
{
  auto out = detail::plan::convex_hull(points);
  if (out.size() > 2) return out;
  auto const [low, high] = std::ranges::minmax(
    points, [](Point2d const& a, Point2d const& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  return low == high ? std::vector{low} : std::vector{low, high};
}

/// Outer rings counterclockwise, holes clockwise, so that the nonzero rule keeps holes open.
std::vector<Point2d> turned(std::vector<Point2d> ring, bool outer)
{
  if ((detail::plan::area(ring) > 0) != outer) std::ranges::reverse(ring);
  return ring;
}

}  // namespace

PlanOutline plan_outline(Scene const& scene, Object const& object)
{
  PlanOutline out;
  for (auto i = object.boxes.first; i < object.boxes.last; ++i) {
    auto const& [a, b] = scene.boxes[i];
    out.rings.push_back({{a.x, a.y}, {b.x, a.y}, {b.x, b.y}, {a.x, b.y}});
  }
  for (auto i = object.balls.first; i < object.balls.last; ++i)
    out.discs.push_back({horizontal(scene.balls[i].centre), scene.balls[i].radius});
  for (auto i = object.prisms.first; i < object.prisms.last; ++i) {
    auto const& rings = scene.prisms[i].rings;
    for (std::size_t k = 0; k < rings.size(); ++k) out.rings.push_back(turned(rings[k], k == 0));
  }
  for (auto i = object.polyhedra.first; i < object.polyhedra.last; ++i) {
    std::vector<Point2d> points;
    for (auto const& v : scene.polyhedra[i].vertices) points.push_back(horizontal(v));
    out.rings.push_back(hull(points));
  }
  for (auto& ring : detail::mesh_outline(scene, object.triangles)) out.rings.push_back(std::move(ring));
  if (!out.rings.empty() || !out.discs.empty()) return out;

  std::vector<Point2d> points;
  for (auto i = object.triangles.first; i < object.triangles.last; ++i)
    for (auto const v : scene.triangles[i]) points.push_back(horizontal(scene.vertices[v]));
  out.rings.push_back(hull(points));
  return out;
}

}  // namespace visibility
