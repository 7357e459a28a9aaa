#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/kernel/point.hpp"

namespace visibility {

namespace detail {
struct Orient3dFormula {
  template <class T>
  auto operator()(T const& px, T const& py, T const& pz, T const& qx, T const& qy, T const& qz, T const& rx,
                  T const& ry, T const& rz, T const& sx, T const& sy, T const& sz) const
  {
    auto const ax = px - sx, ay = py - sy, az = pz - sz;
    auto const bx = qx - sx, by = qy - sy, bz = qz - sz;
    auto const cx = rx - sx, cy = ry - sy, cz = rz - sz;
    return (bx * ay - by * ax) * cz + (by * cx - bx * cy) * az + (ax * cy - ay * cx) * bz;
  }
  /// Two equal points (with s they show as zero differences): lines that share a vertex.
  static bool vanishes(double px, double py, double pz, double qx, double qy, double qz, double rx, double ry,
                       double rz, double, double, double)
  {
    return (px == qx && py == qy && pz == qz) || (px == rx && py == ry && pz == rz) ||
           (qx == rx && qy == ry && qz == rz);
  }
};
}  // namespace detail

/// Sign of det[q-p, r-p, s-p]: positive iff s lies on the side of the plane pqr from which p, q, r appear
/// counterclockwise, zero iff the four points are coplanar. Exact for all finite coordinates (`Filtered`, `Rational`).
/// Laws: antisymmetric -- swapping any two points flips the sign;  even -- an even permutation keeps it.
/// Not true: Shewchuk's orient3d has the opposite sign; CGAL::orientation has this one.
/// Source: [Shewchuk97, Orient3D]; bound: proofs/filters.md.
template <Arithmetic A, class NT>
Sign orient3d(Point3<NT> const& p, Point3<NT> const& q, Point3<NT> const& r, Point3<NT> const& s)
{
  return A::sign(detail::Orient3dFormula{}, p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y, r.z, s.x, s.y, s.z);
}

}  // namespace visibility
