#pragma once

#include "visibility/geometry/ball.hpp"
#include "visibility/geometry/segment_end.hpp"
#include "visibility/predicates/in_ball.hpp"
#include "visibility/predicates/line_ball.hpp"

namespace visibility {

/// Whether the segment from p to q meets the closed ball. Requires: p != q. Exact.
template <Arithmetic A, End end = End::included, class NT>
bool segment_meets(Ball const& ball, Point3<NT> const& p, Point3<NT> const& q)
{
  Point3<NT> const c{NT(ball.centre.x), NT(ball.centre.y), NT(ball.centre.z)};
  NT const r(ball.radius);
  if (!is_negative(in_ball<A>(p, c, r))) return true;
  if (!is_positive(along<A>(p, q, c))) return false;  // moving away from the start on
  if (!is_positive(along<A>(q, p, c))) {              // still approaching at q
    Sign const s = in_ball<A>(q, c, r);
    return is_positive(s) || (end == End::included && is_zero(s));
  }
  return !is_negative(line_ball<A>(p, q, c, r));
}

}  // namespace visibility
