#pragma once

#include "polygon_sides.hpp"

#include "visibility/predicates/orient2d.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace visibility {

/// The upper boundary of a vertical triangle, in plan from one end to the other: two points, or three, all different in
/// plan. Empty for a vertical line. Requires: the corners lie on one line in plan.
inline std::vector<Point3d> upper_boundary(std::array<Point3d, 3> p)
{
  std::ranges::sort(p, {}, [](Point3d const& q) { return std::tie(q.x, q.y, q.z); });
  if (height_field::same_in_plan(p[0], p[2])) return {};
  // Of two corners on one vertical line the upper one comes second.
  if (height_field::same_in_plan(p[0], p[1])) return {p[1], p[2]};
  if (height_field::same_in_plan(p[1], p[2])) return {p[0], p[2]};
  bool const along_x = p[0].x != p[2].x;
  auto const upright = [&](Point3d const& q) { return Point2d{along_x ? q.x : q.y, q.z}; };
  if (is_positive(orient2d<Filtered>(upright(p[0]), upright(p[2]), upright(p[1])))) return {p[0], p[1], p[2]};
  return {p[0], p[2]};
}

}  // namespace visibility
