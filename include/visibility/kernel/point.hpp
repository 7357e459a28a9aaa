#pragma once

#include "visibility/kernel/number_types.hpp"

#include <cmath>
#include <concepts>

namespace visibility {

/// A point of the plane. Aggregate: `Point2d{x, y}`.
template <class NT>
struct Point2 {
  using Number = NT;
  NT x, y;
  friend bool operator==(Point2 const&, Point2 const&) = default;
};

/// A point of space; z is up. Aggregate: `Point3d{x, y, z}`.
template <class NT>
struct Point3 {
  using Number = NT;
  NT x, y, z;
  friend bool operator==(Point3 const&, Point3 const&) = default;
};

using Point2d = Point2<double>;  ///< input point: the doubles are exact
using Point3d = Point3<double>;
using Point2q = Point2<RationalNumber>;  ///< constructed point, in lowest terms
using Point3q = Point3<RationalNumber>;

/// The point seen along the z axis.
template <class NT>
constexpr Point2<NT> horizontal(Point3<NT> const& p)
{
  return {p.x, p.y};
}

/// The point a + t (b - a); for doubles rounded.
template <class NT>
Point3<NT> between(Point3<NT> const& a, Point3<NT> const& b, NT const& t)
{
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/// The double as the rational it is. Requires: finite.
inline Point3q exact(Point3d const& p) { return {RationalNumber(p.x), RationalNumber(p.y), RationalNumber(p.z)}; }
inline Point3q const& exact(Point3q const& p) { return p; }

namespace detail {
/// The double point in another number type.
template <class NT>
Point3<NT> as(Point3d const& p)
{
  return {NT(p.x), NT(p.y), NT(p.z)};
}
}  // namespace detail

inline bool is_finite(Point2d const& p) { return std::isfinite(p.x) && std::isfinite(p.y); }
inline bool is_finite(Point3d const& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace visibility
