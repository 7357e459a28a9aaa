#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/kernel/point.hpp"

namespace visibility {

namespace detail {
struct InBallFormula {
  template <class T>
  auto operator()(T const& px, T const& py, T const& pz, T const& cx, T const& cy, T const& cz, T const& r) const
  {
    auto const dx = px - cx, dy = py - cy, dz = pz - cz;
    return r * r - (dx * dx + dy * dy + dz * dz);
  }
};
}  // namespace detail

/// Sign of r^2 - |p - c|^2: positive iff p lies inside the ball, zero iff on its sphere. Requires: r >= 0.
/// Exact for all finite input (`Filtered`, `Rational`).
template <Arithmetic A, class NT>
Sign in_ball(Point3<NT> const& p, Point3<NT> const& centre, NT const& radius)
{
  return A::sign(detail::InBallFormula{}, p.x, p.y, p.z, centre.x, centre.y, centre.z, radius);
}

}  // namespace visibility
