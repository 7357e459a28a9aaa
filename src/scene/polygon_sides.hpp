#pragma once

#include "visibility/predicates/orient2d.hpp"

#include <algorithm>
#include <span>
#include <tuple>

/// Points in plan; corners of convex polygons in plan, counterclockwise, and their sides.
namespace visibility::height_field {

/// Lexicographically, whatever their heights.
inline bool less_in_plan(Point3d const& p, Point3d const& q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); }
inline bool same_in_plan(Point3d const& p, Point3d const& q) { return p.x == q.x && p.y == q.y; }

using Corners = std::span<Point3d const>;

inline bool are_zero(Sign s, Sign t) { return is_zero(s) && is_zero(t); }

/// Calls visit(p, q) for the sides of a polygon until it returns true. Returns whether it did.
template <class Visit>
bool any_side(Corners corners, Visit&& visit)
{
  for (std::size_t i = corners.size() - 1, j = 0; j < corners.size(); i = j++)
    if (visit(corners[i], corners[j])) return true;
  return false;
}

/// Side of the directed line p -> q on which r stands in plan; positive: to the left.
inline Sign side_of(Point3d const& p, Point3d const& q, Point3d const& r)
{
  return orient2d<Filtered>(horizontal(p), horizontal(q), horizontal(r));
}

inline bool has_corner_beside(Corners corners, Point3d const& a, Point3d const& b, Sign side)
{
  return std::ranges::any_of(corners, [&](Point3d const& r) { return side_of(a, b, r) == side; });
}

/// Whether the line of a side of the polygon has the segment on its outside, touching it or not; a segment on the line
/// is not outside.
inline bool has_outside(Corners corners, Point3d const& a, Point3d const& b)
{
  return any_side(corners, [&](Point3d const& p, Point3d const& q) {
    Sign const at_a = side_of(p, q, a), at_b = side_of(p, q, b);
    return !is_positive(at_a) && !is_positive(at_b) && !are_zero(at_a, at_b);
  });
}

/// Whether the line of a side of `c` has all of the polygon `d` strictly on its outside.
inline bool separates_strictly(Corners c, Corners d)
{
  return any_side(c, [&](Point3d const& p, Point3d const& q) {
    return std::ranges::all_of(d, [&](Point3d const& r) { return is_negative(side_of(p, q, r)); });
  });
}

/// Whether the line of a side of `c` separates the polygon `d` from it, touching it or not.
inline bool separates(Corners c, Corners d)
{
  return any_side(c, [&](Point3d const& p, Point3d const& q) { return !has_corner_beside(d, p, q, Sign::positive); });
}

}  // namespace visibility::height_field
