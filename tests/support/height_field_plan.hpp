#pragma once

#include "support/height_field_oracle.hpp"

#include <array>
#include <cstdint>
#include <vector>

/// The plan of a height field in homogeneous coordinates: a line of the plane is the vector l, a point the vector p,
/// and l.p > 0 left of the directed line, which runs along (l_y, -l_x). All coordinates are polynomials in the input,
/// so that a ring of exact numbers suffices.
namespace visibility::oracle::detail {

using NT = ExactNumber;

struct Vector {
  NT x, y, z;
};
inline NT dot(Vector const& a, Vector const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(Vector const& a, Vector const& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector operator+(Vector const& a, Vector const& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator*(NT const& f, Vector const& a) { return {f * a.x, f * a.y, f * a.z}; }
inline Vector operator-(Vector const& a) { return {-a.x, -a.y, -a.z}; }
inline bool is_zero(Vector const& a) { return a.x == 0 && a.y == 0 && a.z == 0; }
inline int sign(NT const& a) { return static_cast<int>(CGAL::sign(a)); }

/// A top: the height over the point p is dot(form, p) / (scale p.z), scale > 0.
struct Plane {
  Vector form;
  NT scale;
};

/// A set of polygons: bit i is column i, then comes the cell, then the target if it is no column.
using Polygons = std::uint64_t;
constexpr Polygons polygon_bit(int i) { return Polygons{1} << i; }

/// Where the upper envelope over a line may break: a side of a polygon, or where two tops cross over both polygons.
struct Segment {
  Vector a, b;  ///< ends, z > 0
  Vector line;  ///< a positive multiple of cross(a, b)
  Polygons owners;
  bool face = true;
};

/// A point of the plane at which the order of segments along a line changes when the line sweeps over it.
struct Event {
  Vector point;
  Polygons owners;  ///< it matters only where all of these do
};

struct Plan {
  /// `target`: a convex polygon that is no column, counterclockwise with area in plan; or two points, the upper edge of
  /// a fence: what a vertical polygon looks like in plan.
  Plan(std::span<Column const> columns, Cell const& cell, std::span<Point3d const> target = {});

  Point2d origin;  ///< of the plan's coordinates, a corner of the cell
  double unit;     ///< of them, a power of two: the whole plan lies about as far from the origin. A choice.

  int columns;                                ///< the cell is the polygon of that number
  std::vector<std::vector<Vector>> polygons;  ///< corners
  std::vector<Plane> tops;
  std::vector<int> first_side;  ///< of each polygon: a segment; the others follow
  std::vector<Segment> segments;
  std::vector<Event> events;  ///< corners first
  int first_ridge;            ///< segments from here on are ridges

  int cell() const { return columns; }
  int target() const { return columns + 1; }
  int polygon_count() const { return static_cast<int>(polygons.size()); }
  bool is_fence(int polygon) const { return polygons[std::size_t(polygon)].size() == 2; }
  /// Where a point of the plan lies in the scene.
  Point3q in_scene(Point2q const& p, RationalNumber const& z) const
  {
    using Q = RationalNumber;
    return {p.x * Q(unit) + Q(origin.x), p.y * Q(unit) + Q(origin.y), z};
  }
  int side_count(int polygon) const
  {
    return is_fence(polygon) ? 1 : static_cast<int>(polygons[std::size_t(polygon)].size());
  }

private:
  Vector point(double x, double y) const
  {
    return {NT(1 / unit) * (NT(x) - NT(origin.x)), NT(1 / unit) * (NT(y) - NT(origin.y)), NT(1)};
  }
  Plane top_of(std::span<Point3d const> corners) const;
  Plane top_of_fence(Point3d const& a, Point3d const& b) const;
  void add_target(std::span<Point3d const> corners);
  void add_polygon(std::vector<Vector> const& corners, Plane const& top, std::vector<bool> const& inner);
  bool in(int polygon, Vector const& point) const;
  void add_ridge(int i, int j);
  void add_piercing(int fence, int column);
  void add_crossings();
};

}  // namespace visibility::oracle::detail
