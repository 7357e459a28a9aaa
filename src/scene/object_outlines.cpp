#include "visibility/scene/object_outlines.hpp"

#include "plan.hpp"

#include <algorithm>
#include <array>

namespace visibility {

namespace {

using detail::plan::Polygon;

/// Leaves out points that certainly are not corners of the hull: those well inside a polygon of points that are extreme
/// in eight directions. Rounded, with a margin that is far above the roundings.
void leave_out_inner(Polygon& points)
{
  constexpr std::array<Point2d, 8> ways{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  Polygon extreme;
  double size = 0;
  for (auto const& way : ways)
    extreme.push_back(
      *std::ranges::max_element(points, {}, [&](Point2d const& p) { return way.x * p.x + way.y * p.y; }));
  for (auto const& p : extreme) size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
  if (std::ranges::all_of(extreme, [&](Point2d const& p) { return p == extreme[0]; })) return;
  // What lies on the left of all edges is gone round by them, so it lies in the hull, even if roundings bent the
  // polygon.
  double const margin = 0x1p-45 * size * size;
  std::erase_if(points, [&](Point2d const& p) {
    for (std::size_t i = 0; i < extreme.size(); ++i) {
      Point2d const &a = extreme[i], &b = extreme[(i + 1) % extreme.size()];
      if (a != b && !(detail::plan::turn(a, b, p) > margin)) return false;
    }
    return true;
  });
}

}  // namespace

ObjectOutlines::ObjectOutlines(ConvexBodies const& bodies)
{
  std::vector<Point3d> vertices;
  Polygon plan;
  first_.push_back(0);
  for (std::uint32_t o = 0; o < bodies.scene().objects.size(); ++o) {
    auto const listed = bodies.bodies_of(o);
    if (listed.size() > few_bodies) {
      vertices.clear();
      for (auto const& b : listed) bodies.append_vertices(b, vertices);
      plan.clear();
      for (auto const& p : vertices) plan.push_back(horizontal(p));
      leave_out_inner(plan);
      auto const hull = detail::plan::convex_hull(plan);
      corners_.insert(corners_.end(), hull.begin(), hull.end());
    }
    first_.push_back(corners_.size());
  }
}

}  // namespace visibility
