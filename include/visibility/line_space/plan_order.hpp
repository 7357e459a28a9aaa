#pragma once

#include "visibility/line_space/funnel.hpp"

namespace visibility {

/// Where an edge is crossed along the directed lines that cross it and another one.
enum class PlanOrder : std::uint8_t {
  before,
  after,
  collinear,  ///< both lie on one line: no sight line but that one tells them apart
  crossing    ///< they cross in plan: before on one side of the crossing point, after on the other
};

/// Where `f` is crossed relative to `e`. Requires: some directed line has both left ends on its left and both right
/// ends on its right; unless the edges cross, the answer then holds for all such lines. Exact.
template <Arithmetic A, class NT>
PlanOrder plan_order(Gate<NT> const& e, Gate<NT> const& f)
{
  // Ahead of a gate is the left side of left -> right.
  Sign const fl = orient2d<A>(e.left, e.right, f.left), fr = orient2d<A>(e.left, e.right, f.right);
  if (is_zero(fl) && is_zero(fr)) return PlanOrder::collinear;
  if (!is_negative(fl) && !is_negative(fr)) return PlanOrder::after;
  if (!is_positive(fl) && !is_positive(fr)) return PlanOrder::before;
  Sign const el = orient2d<A>(f.left, f.right, e.left), er = orient2d<A>(f.left, f.right, e.right);
  if (!is_negative(el) && !is_negative(er)) return PlanOrder::before;
  if (!is_positive(el) && !is_positive(er)) return PlanOrder::after;
  return PlanOrder::crossing;
}

}  // namespace visibility
