#pragma once

#include "visibility/kernel/point.hpp"

#include <cmath>
#include <vector>

/// Polygons in floating point, for choosing candidates; only `convex_hull` is exact.
namespace visibility::detail::plan {

using Polygon = std::vector<Point2d>;  ///< open: the first point is not repeated

/// Twice the signed area of abc, rounded.
inline double turn(Point2d const& a, Point2d const& b, Point2d const& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
inline double distance(Point2d const& a, Point2d const& b)
{
  return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

double area(Polygon const& polygon);  ///< signed
double perimeter(Polygon const& polygon);
Point2d mean(Polygon const& polygon);  ///< of the corners

/// Signed distance of p from the line ab, positive on its left. Requires: a != b.
double left_of(Point2d const& a, Point2d const& b, Point2d const& p);

/// The part of a convex polygon on the left of the line ab. A cut on a line of constant x or y gets that coordinate.
Polygon clip(Polygon const& convex, Point2d const& a, Point2d const& b);

/// Whether some point of the segment is more than `slack` inside the convex counterclockwise polygon.
bool enters(Polygon const& convex, Point2d const& p, Point2d const& q, double slack);

/// Whether every point of `inner` is within `slack` of the convex counterclockwise polygon or inside.
bool contains(Polygon const& convex, Polygon const& inner, double slack);

/// The polygon with every corner moved towards their mean by a part `by` of its distance.
Polygon shrunk(Polygon const& polygon, double by);

/// Corners of the convex hull, counterclockwise, all turns strictly left; fewer than three if all points are collinear.
/// Exact: keeps points bit for bit.
Polygon convex_hull(Polygon points);

/// The convex polygon without the corners that it loses the least area by, until at most `most` are left: a polygon
/// inside it.
Polygon with_few_corners(Polygon convex, std::size_t most);

/// Without corners that lie within `slack` of the line between their neighbours.
Polygon without_straight_corners(Polygon const& polygon, double slack);

}  // namespace visibility::detail::plan
