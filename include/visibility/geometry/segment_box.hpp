#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/geometry/segment_end.hpp"
#include "visibility/predicates/orient2d.hpp"

namespace visibility {

namespace detail {

/// Whether p lies strictly outside the slab [lo, hi] on a side on which q lies outside too (End::excluded: or on).
template <End end, class NT>
bool beyond_slab(NT const& p, NT const& q, double lo, double hi)
{
  if constexpr (end == End::included) return (p < lo && q < lo) || (p > hi && q > hi);
  return (p < lo && q <= lo) || (p > hi && q >= hi);
}

/// Whether the rectangle [lo, hi] lies strictly on one side of the line pq (never, if p = q).
template <Arithmetic A, class NT>
bool line_misses_rectangle(Point2<NT> const& p, Point2<NT> const& q, Point2<NT> const& lo, Point2<NT> const& hi)
{
  // The two corners that are extreme across the line: which diagonal they span depends on the direction's quadrant.
  bool const rising = (p.x <= q.x) == (p.y <= q.y);
  Point2<NT> const a = rising ? Point2<NT>{lo.x, hi.y} : lo;
  Point2<NT> const b = rising ? Point2<NT>{hi.x, lo.y} : hi;
  Sign const s = orient2d<A>(p, q, a);
  return !is_zero(s) && orient2d<A>(p, q, b) == s;
}

}  // namespace detail

/// Whether the line through p and q meets the closed box, given that its segment [p, q] or [p, q) passes beside no slab
/// of the box. Requires: p != q. Exact: what is left are the three edge x direction separating axes, and each of them
/// is an orient2d of input points in a coordinate plane (proofs/segment_convex.md).
template <Arithmetic A, class NT>
bool line_meets(Box const& box, Point3<NT> const& p, Point3<NT> const& q)
{
  Point3<NT> const lo{NT(box.min.x), NT(box.min.y), NT(box.min.z)}, hi{NT(box.max.x), NT(box.max.y), NT(box.max.z)};
  using P = Point2<NT>;
  return !detail::line_misses_rectangle<A>(P{p.x, p.y}, P{q.x, q.y}, P{lo.x, lo.y}, P{hi.x, hi.y}) &&
         !detail::line_misses_rectangle<A>(P{p.x, p.z}, P{q.x, q.z}, P{lo.x, lo.z}, P{hi.x, hi.z}) &&
         !detail::line_misses_rectangle<A>(P{p.y, p.z}, P{q.y, q.z}, P{lo.y, lo.z}, P{hi.y, hi.z});
}

/// Whether the segment from p to q meets the closed box. Requires: p != q. Exact.
template <Arithmetic A, End end = End::included, class NT>
bool segment_meets(Box const& box, Point3<NT> const& p, Point3<NT> const& q)
{
  return !detail::beyond_slab<end>(p.x, q.x, box.min.x, box.max.x) &&
         !detail::beyond_slab<end>(p.y, q.y, box.min.y, box.max.y) &&
         !detail::beyond_slab<end>(p.z, q.z, box.min.z, box.max.z) && line_meets<A>(box, p, q);
}

}  // namespace visibility
