#pragma once

#include "visibility/geometry/facet_stab.hpp"
#include "visibility/geometry/segment_coplanar.hpp"
#include "visibility/geometry/segment_end.hpp"
#include "visibility/geometry/triangle.hpp"
#include "visibility/predicates/line_side.hpp"

namespace visibility {

/// Whether the segment from p to q meets the closed triangle abc, which may be degenerate. Requires: p != q. Exact.
template <Arithmetic A, End end = End::included, class NT>
bool segment_meets(Point3<NT> const& a, Point3<NT> const& b, Point3<NT> const& c, Point3<NT> const& p,
                   Point3<NT> const& q)
{
  Sign const sp = orient3d<A>(a, b, c, p), sq = orient3d<A>(a, b, c, q);
  if (is_zero(sp) && is_zero(sq)) return detail::coplanar_segment_meets_triangle<A, end>(a, b, c, p, q);
  if (sp == sq || (end == End::excluded && is_zero(sq))) return false;
  // One end off the plane: the line meets the plane in one point of the segment.
  detail::FacetStab stab;
  stab.add(line_side<A>(p, q, a, b));
  stab.add(line_side<A>(p, q, b, c));
  stab.add(line_side<A>(p, q, c, a));
  return stab.hit();
}

template <Arithmetic A, End end = End::included, class NT>
bool segment_meets(Triangle const& t, Point3<NT> const& p, Point3<NT> const& q)
{
  auto const v = [&](int i) {
    auto const& x = t.vertices[static_cast<std::size_t>(i)];
    return Point3<NT>{NT(x.x), NT(x.y), NT(x.z)};
  };
  return segment_meets<A, end>(v(0), v(1), v(2), p, q);
}

}  // namespace visibility
