#pragma once

#include "visibility/scene/height_field.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace visibility::height_field {

/// The height x a + y b + c, in rationals.
struct Plane {
  RationalNumber a, b, c;
  RationalNumber over(Point2q const& p) const { return a * p.x + b * p.y + c; }
  bool is_level() const { return a == 0 && b == 0; }
};
inline Plane operator-(Plane const& p, Plane const& q) { return {p.a - q.a, p.b - q.b, p.c - q.c}; }

/// Two points of the line in plan over which a plane has height 0; it is below 0 on the right of p -> q.
/// Requires: not level.
inline std::pair<Point2q, Point2q> crease_line(Plane const& rise)
{
  RationalNumber const square = rise.a * rise.a + rise.b * rise.b;
  Point2q const p{-rise.c * rise.a / square, -rise.c * rise.b / square};
  return {p, {p.x + rise.b, p.y - rise.a}};
}

/// The plane through a polygon that is flat, or else a triangle, and has area in plan.
inline Plane plane_of(std::span<Point3d const> corners)
{
  using NT = RationalNumber;
  if (std::ranges::all_of(corners, [&](Point3d const& p) { return p.z == corners[0].z; }))
    return {0, 0, NT(corners[0].z)};
  auto const o = exact(corners[0]), p = exact(corners[1]), q = exact(corners[2]);
  NT const px = p.x - o.x, py = p.y - o.y, pz = p.z - o.z, qx = q.x - o.x, qy = q.y - o.y, qz = q.z - o.z;
  NT const area = px * qy - py * qx;
  NT const a = (pz * qy - py * qz) / area, b = (px * qz - pz * qx) / area;
  return {a, b, o.z - a * o.x - b * o.y};
}

/// The plane of a column's top. Requires: no curtain.
inline Plane top_plane(HeightField const& field, HeightField::Column const& column)
{
  return plane_of(field.corners(column));
}

}  // namespace visibility::height_field
