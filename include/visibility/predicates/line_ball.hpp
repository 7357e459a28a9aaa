#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/kernel/point.hpp"

namespace visibility {

namespace detail {
struct AlongFormula {
  template <class T>
  auto operator()(T const& px, T const& py, T const& pz, T const& qx, T const& qy, T const& qz, T const& cx,
                  T const& cy, T const& cz) const
  {
    return (cx - px) * (qx - px) + (cy - py) * (qy - py) + (cz - pz) * (qz - pz);
  }
};
struct LineBallFormula {
  template <class T>
  auto operator()(T const& px, T const& py, T const& pz, T const& qx, T const& qy, T const& qz, T const& cx,
                  T const& cy, T const& cz, T const& r) const
  {
    auto const dx = qx - px, dy = qy - py, dz = qz - pz;
    auto const ex = cx - px, ey = cy - py, ez = cz - pz;
    auto const nx = ey * dz - ez * dy, ny = ez * dx - ex * dz, nz = ex * dy - ey * dx;
    return (r * r) * (dx * dx + dy * dy + dz * dz) - (nx * nx + ny * ny + nz * nz);
  }
};
}  // namespace detail

/// Sign of (c - p).(q - p): positive iff the foot of c on the line pq lies beyond p in the direction of q. Exact.
template <Arithmetic A, class NT>
Sign along(Point3<NT> const& p, Point3<NT> const& q, Point3<NT> const& c)
{
  return A::sign(detail::AlongFormula{}, p.x, p.y, p.z, q.x, q.y, q.z, c.x, c.y, c.z);
}

/// Sign of r^2 |q-p|^2 - |(c-p) x (q-p)|^2: positive iff the line pq passes through the interior of the ball, zero iff
/// it is tangent (or p = q). Degree 4, exact. Requires: r >= 0.
template <Arithmetic A, class NT>
Sign line_ball(Point3<NT> const& p, Point3<NT> const& q, Point3<NT> const& centre, NT const& radius)
{
  return A::sign(detail::LineBallFormula{}, p.x, p.y, p.z, q.x, q.y, q.z, centre.x, centre.y, centre.z, radius);
}

}  // namespace visibility
