#pragma once

#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <span>

namespace visibility::exact_25d {

/// Whether the open segment p -> q passes through the relative interior of a plane convex polygon, from one side of its
/// plane to the other. Requires: flat, or the first three corners do not lie on one line. Exact.
template <Arithmetic A>
bool pierces(Point3d const& p, Point3d const& q, std::span<Point3d const> polygon)
{
  auto const &a = polygon[0], &b = polygon[1], &c = polygon[2];
  bool const flat = std::ranges::all_of(polygon, [&](Point3d const& r) { return r.z == a.z; });
  auto const side = [&](Point3d const& r) { return flat ? sign_of(r.z - a.z) : orient3d<A>(a, b, c, r); };
  if (!is_negative(side(p) * side(q))) return false;
  Sign turn = Sign::zero;
  for (std::size_t i = polygon.size() - 1, j = 0; j < polygon.size(); i = j++) {
    Sign const s = orient3d<A>(p, q, polygon[i], polygon[j]);
    if (is_zero(s) || is_negative(s * turn)) return false;
    turn = s;
  }
  return true;
}

/// Where it does. Requires: it does.
inline Point3q piercing_point(Point3d const& p, Point3d const& q, std::span<Point3d const> polygon)
{
  using R = RationalNumber;
  Point3q const a = exact(polygon[0]), b = exact(polygon[1]), c = exact(polygon[2]), from = exact(p), to = exact(q);
  bool const flat = std::ranges::all_of(polygon, [&](Point3d const& r) { return r.z == polygon[0].z; });
  auto const height = [&](Point3q const& r) -> R {
    if (flat) return r.z - a.z;
    return visibility::detail::Orient3dFormula{}(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, r.x, r.y, r.z);
  };
  R const at_from = height(from);
  return between(from, to, R(at_from / (at_from - height(to))));
}

}  // namespace visibility::exact_25d
