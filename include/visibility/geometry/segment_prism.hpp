#pragma once

#include "visibility/geometry/convex_prism.hpp"
#include "visibility/geometry/facet_stab.hpp"
#include "visibility/geometry/segment_box.hpp"
#include "visibility/predicates/line_side.hpp"

namespace visibility {

namespace detail {

/// Whether the vertical segment-curtain from p to q, seen from above, misses the convex footprint: both ends beyond
/// one wall, or the footprint strictly on one side of the line pq.
template <Arithmetic A, End end, class NT>
bool misses_footprint(std::vector<Point2d> const& footprint, Point2<NT> const& p, Point2<NT> const& q)
{
  bool left = false, right = false;
  for (std::size_t i = 0, n = footprint.size(); i < n; ++i) {
    Point2<NT> const a{NT(footprint[i].x), NT(footprint[i].y)};
    Point2<NT> const b{NT(footprint[(i + 1) % n].x), NT(footprint[(i + 1) % n].y)};
    if (is_negative(orient2d<A>(a, b, p))) {
      Sign const s = orient2d<A>(a, b, q);
      if (is_negative(s) || (end == End::excluded && is_zero(s))) return true;
    }
    Sign const s = orient2d<A>(p, q, a);
    left |= !is_negative(s);
    right |= !is_positive(s);
  }
  return !(left && right);
}

/// Whether the line pq stabs a facet of the prism. Requires: p != q.
template <Arithmetic A, class NT>
bool line_stabs(ConvexPrism const& prism, Point3<NT> const& p, Point3<NT> const& q)
{
  std::size_t const n = prism.footprint.size();
  NT const bottom(prism.bottom), top(prism.top);
  auto const vertex = [&](std::size_t i, NT const& z) {
    Point2d const& v = prism.footprint[i % n];
    return Point3<NT>{NT(v.x), NT(v.y), z};
  };
  FacetStab floor, roof;
  for (std::size_t i = 0; i < n; ++i) {
    auto const a = vertex(i, bottom), b = vertex(i + 1, bottom), c = vertex(i + 1, top), d = vertex(i, top);
    Sign const low = line_side<A>(p, q, a, b), high = line_side<A>(p, q, c, d);
    floor.add(low);
    roof.add(high);
    FacetStab wall;
    wall.add(low);
    wall.add(high);
    // The side of a vertical edge is an orient2d of its foot (proofs/plucker.md).
    wall.add(orient2d<A>(horizontal(p), horizontal(q), horizontal(b)));
    wall.add(-orient2d<A>(horizontal(p), horizontal(q), horizontal(d)));
    if (wall.hit()) return true;
  }
  return floor.hit() || roof.hit();
}

}  // namespace detail

/// Whether the segment from p to q meets the closed prism. Requires: p != q. Exact, see segment_polyhedron.hpp; walls
/// and vertical edges are decided in the plane.
template <Arithmetic A, End end = End::included, class NT>
bool segment_meets(ConvexPrism const& prism, Point3<NT> const& p, Point3<NT> const& q)
{
  if (detail::beyond_slab<end>(p.z, q.z, prism.bottom, prism.top)) return false;
  if (detail::misses_footprint<A, end>(prism.footprint, horizontal(p), horizontal(q))) return false;
  // Seen from above it meets the footprint, so a segment between floor and roof meets the prism.
  auto const within = [&](NT const& z) { return prism.bottom <= z && z <= prism.top; };
  if (within(p.z) && within(q.z)) return true;
  return detail::line_stabs<A>(prism, p, q);
}

}  // namespace visibility
