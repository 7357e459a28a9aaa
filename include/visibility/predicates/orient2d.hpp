#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/kernel/point.hpp"

namespace visibility {

namespace detail {
struct Orient2dFormula {
  template <class T>
  auto operator()(T const& px, T const& py, T const& qx, T const& qy, T const& rx, T const& ry) const
  {
    return (px - rx) * (qy - ry) - (py - ry) * (qx - rx);
  }
  /// Two equal points (with r they show as zero differences).
  static bool vanishes(double px, double py, double qx, double qy, double, double) { return px == qx && py == qy; }
};
}  // namespace detail

/// Sign of det[q-p, r-p]: positive iff p, q, r turn counterclockwise, zero iff they are collinear.
/// Exact for all finite coordinates (`Filtered`, `Rational`).
/// Laws: cyclic -- orient2d(q,r,p) == orient2d(p,q,r);  antisymmetric -- orient2d(q,p,r) == -orient2d(p,q,r).
/// Not true: invariance under rounded translation.  Source: [Shewchuk97, Orient2D]; bound: proofs/filters.md.
template <Arithmetic A, class NT>
Sign orient2d(Point2<NT> const& p, Point2<NT> const& q, Point2<NT> const& r)
{
  return A::sign(detail::Orient2dFormula{}, p.x, p.y, q.x, q.y, r.x, r.y);
}

}  // namespace visibility
