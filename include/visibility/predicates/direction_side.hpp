#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/kernel/point.hpp"

namespace visibility {

namespace detail {
struct DirectionSide2dFormula {
  template <class T>
  auto operator()(T const& ax, T const& ay, T const& bx, T const& by, T const& px, T const& py, T const& qx,
                  T const& qy) const
  {
    return (qx - px) * (by - ay) - (qy - py) * (bx - ax);
  }
};
struct DirectionSide3dFormula {
  template <class T>
  auto operator()(T const& ax, T const& ay, T const& az, T const& bx, T const& by, T const& bz, T const& px,
                  T const& py, T const& pz, T const& qx, T const& qy, T const& qz, T const& rx, T const& ry,
                  T const& rz) const
  {
    auto const dx = bx - ax, dy = by - ay, dz = bz - az;
    auto const ux = qx - px, uy = qy - py, uz = qz - pz;
    auto const vx = rx - px, vy = ry - py, vz = rz - pz;
    return (uy * vz - uz * vy) * dx + (uz * vx - ux * vz) * dy + (ux * vy - uy * vx) * dz;
  }
};
}  // namespace detail

/// Sign of det[q-p, b-a]: positive iff the direction from a to b turns left of the direction from p to q, zero iff they
/// are parallel. Exact for all finite coordinates (`Filtered`, `Rational`).
/// Laws: antisymmetric -- swapping a with b, or p with q, flips the sign;  start -- for a = p it is orient2d(p, q, b).
template <Arithmetic A, class NT>
Sign direction_side(Point2<NT> const& a, Point2<NT> const& b, Point2<NT> const& p, Point2<NT> const& q)
{
  return A::sign(detail::DirectionSide2dFormula{}, a.x, a.y, b.x, b.y, p.x, p.y, q.x, q.y);
}

/// Sign of det[b-a, q-p, r-p]: positive iff moving from a to b moves towards the positive side of the plane pqr (the
/// one of orient3d), zero iff ab is parallel to it or p, q, r are collinear. Exact for all finite coordinates.
/// Laws: antisymmetric -- swapping a with b, or two of p, q, r, flips the sign;  start -- for a = p it is
/// orient3d(p, q, r, b).
template <Arithmetic A, class NT>
Sign direction_side(Point3<NT> const& a, Point3<NT> const& b, Point3<NT> const& p, Point3<NT> const& q,
                    Point3<NT> const& r)
{
  return A::sign(detail::DirectionSide3dFormula{}, a.x, a.y, a.z, b.x, b.y, b.z, p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y,
                 r.z);
}

}  // namespace visibility
