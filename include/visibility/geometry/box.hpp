#pragma once

#include "visibility/kernel/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace visibility {

/// Closed axis-aligned box [min, max]. May be flat; a default-constructed one is empty.
struct Box {
  Point3d min{inf, inf, inf};
  Point3d max{-inf, -inf, -inf};
  friend bool operator==(Box const&, Box const&) = default;

  bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  bool has_interior() const { return min.x < max.x && min.y < max.y && min.z < max.z; }

  /// Corner i takes max.x iff bit 0 of i is set, max.y iff bit 1, max.z iff bit 2.
  Point3d corner(int i) const
  {
    return {(i & 1) != 0 ? max.x : min.x, (i & 2) != 0 ? max.y : min.y, (i & 4) != 0 ? max.z : min.z};
  }
  std::array<Point3d, 8> corners() const
  {
    return {corner(0), corner(1), corner(2), corner(3), corner(4), corner(5), corner(6), corner(7)};
  }

  void extend(Point3d const& p)
  {
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
  }
  void extend(Box const& b)
  {
    min = {std::min(min.x, b.min.x), std::min(min.y, b.min.y), std::min(min.z, b.min.z)};
    max = {std::max(max.x, b.max.x), std::max(max.y, b.max.y), std::max(max.z, b.max.z)};
  }

private:
  static constexpr double inf = std::numeric_limits<double>::infinity();
};

/// Whether the closed boxes share a point.
inline bool meet(Box const& a, Box const& b)
{
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

inline bool contains(Box const& box, Point3d const& p)
{
  return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y && box.min.z <= p.z &&
         p.z <= box.max.z;
}

/// Rounded squared distance between the boxes; a key for approximate order only, never for a verdict.
inline double approximate_squared_distance(Box const& a, Box const& b)
{
  double const dx = std::max(0.0, std::max(a.min.x - b.max.x, b.min.x - a.max.x));
  double const dy = std::max(0.0, std::max(a.min.y - b.max.y, b.min.y - a.max.y));
  double const dz = std::max(0.0, std::max(a.min.z - b.max.z, b.min.z - a.max.z));
  return dx * dx + dy * dy + dz * dz;
}

}  // namespace visibility
