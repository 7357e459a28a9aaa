#pragma once

#include "visibility/geometry/convex_polyhedron.hpp"
#include "visibility/geometry/facet_stab.hpp"
#include "visibility/geometry/segment_end.hpp"
#include "visibility/predicates/line_side.hpp"

#include <algorithm>

namespace visibility {

namespace detail {

/// Whether some facet's plane has p strictly outside and q outside or (End::excluded) on it.
template <Arithmetic A, End end, class NT>
bool beyond_facet(ConvexPolyhedron const& body, Point3<NT> const& p, Point3<NT> const& q)
{
  return std::ranges::any_of(body.facets, [&](ConvexPolyhedron::Facet const& f) {
    auto const a = as<NT>(body.vertices[f.vertices[0]]), b = as<NT>(body.vertices[f.vertices[1]]),
               c = as<NT>(body.vertices[f.vertices[2]]);
    if (!is_positive(orient3d<A>(a, b, c, p))) return false;
    Sign const s = orient3d<A>(a, b, c, q);
    return is_positive(s) || (end == End::excluded && is_zero(s));
  });
}

/// Whether the line pq meets the closed polyhedron. Requires: p != q.
template <Arithmetic A, class NT>
bool line_meets(ConvexPolyhedron const& body, Point3<NT> const& p, Point3<NT> const& q)
{
  thread_local std::vector<Sign> side;
  side.clear();
  for (auto const& e : body.edges)
    side.push_back(line_side<A>(p, q, as<NT>(body.vertices[e.from]), as<NT>(body.vertices[e.to])));
  return std::ranges::any_of(body.facets, [&](ConvexPolyhedron::Facet const& f) {
    FacetStab stab;
    for (auto const e : f.edges) stab.add(e >= 0 ? side[e] : -side[~e]);
    return stab.hit();
  });
}

}  // namespace detail

/// Whether the segment from p to q meets the closed convex polyhedron. Requires: p != q. Exact: a segment misses it iff
/// both ends lie beyond one facet's plane or its line misses it, and a line meets it iff it stabs a facet; every sign
/// is an orient3d of input points (proofs/segment_convex.md).
template <Arithmetic A, End end = End::included, class NT>
bool segment_meets(ConvexPolyhedron const& body, Point3<NT> const& p, Point3<NT> const& q)
{
  return !detail::beyond_facet<A, end>(body, p, q) && detail::line_meets<A>(body, p, q);
}

}  // namespace visibility
