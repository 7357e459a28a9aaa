#pragma once

#include "visibility/geometry/convex_polyhedron.hpp"
#include "visibility/geometry/convex_prism.hpp"
#include "visibility/geometry/triangle.hpp"
#include "visibility/predicates/direction_side.hpp"
#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>

/// Whether a closed triangle meets the open interior of a convex body: they are disjoint iff a plane separates them
/// that is parallel to a facet of the body, to the triangle, or to an edge of each (proofs/triangle_interior.md). Every
/// sign is a polynomial of degree at most 3 in the coordinates of input points.
namespace visibility {

namespace detail {

/// Signs that are all on one side, touching allowed, and not all zero.
class OneSided {
public:
  void add(Sign s)
  {
    positive_ |= is_positive(s);
    negative_ |= is_negative(s);
  }
  bool holds() const { return positive_ != negative_; }

private:
  bool positive_ = false, negative_ = false;
};

inline Point2d footprint_point(ConvexPrism const& k, std::size_t i) { return k.footprint[i % k.footprint.size()]; }

/// Whether a vertical plane through the triangle's edge ab has the prism on one side and c on the other.
template <Arithmetic A>
bool vertical_plane_separates(ConvexPrism const& k, Point2d const& a, Point2d const& b, Point2d const& c)
{
  OneSided side;
  for (auto const& v : k.footprint) side.add(orient2d<A>(a, b, v));
  if (!side.holds()) return false;  // also if a == b
  side.add(-orient2d<A>(a, b, c));
  return side.holds();
}

/// Whether the plane through the prism's edge uv, of its roof or its floor, that is parallel to the triangle's edge ab
/// has the prism on one side and the triangle on the other. With the outward normal w of the wall at uv, the plane's
/// normal is (v-u) x (b-a) = (b.z-a.z) w + det[v-u, b-a] (0, 0, 1): it supports the prism iff the coefficients of w and
/// of the cap's normal do not differ in sign.
template <Arithmetic A>
bool cap_edge_separates(Point3d const& u, Point3d const& v, Sign cap, Point3d const& a, Point3d const& b,
                        Point3d const& c)
{
  if (a.z == b.z) return false;  // parallel to the cap
  Sign const outward = a.z < b.z ? Sign::positive : Sign::negative;
  if (direction_side<A>(horizontal(a), horizontal(b), horizontal(u), horizontal(v)) * cap != outward) return false;
  return orient3d<A>(u, v, a, b) * outward != Sign::positive &&
         direction_side<A>(u, v, a, b, c) * outward != Sign::negative;
}

/// Whether the plane through the polyhedron's edge uv that is parallel to the triangle's edge ab separates; w and x are
/// the third vertices of the two facets at uv.
template <Arithmetic A>
bool edges_separate(Point3d const& u, Point3d const& v, Point3d const& w, Point3d const& x, Point3d const& a,
                    Point3d const& b, Point3d const& c)
{
  OneSided body;  // the sides of w and x, seen along the normal (v-u) x (b-a)
  Sign const sw = direction_side<A>(a, b, u, w, v), sx = direction_side<A>(a, b, u, x, v);
  body.add(sw), body.add(sx);
  if (!body.holds()) return false;  // not supporting, or parallel to both facets
  Sign const outward = is_zero(sw) ? -sx : -sw;
  return orient3d<A>(u, v, a, b) * outward != Sign::positive &&
         direction_side<A>(u, v, a, b, c) * outward != Sign::negative;
}

/// separates(a, b, c) for some edge ab of the triangle, c being its third vertex.
template <class Separates>
bool any_edge(Triangle const& t, Separates const& separates)
{
  auto const& [a, b, c] = t.vertices;
  return separates(a, b, c) || separates(b, c, a) || separates(c, a, b);
}

}  // namespace detail

/// Whether the closed triangle, which may be degenerate, has a point in the open interior of the prism. Exact.
/// Requires: the prism's invariant.
template <Arithmetic A>
bool meets_interior(Triangle const& t, ConvexPrism const& k)
{
  auto const none = [&](auto const& inside) { return std::ranges::none_of(t.vertices, inside); };
  std::size_t const n = k.footprint.size();
  if (none([&](Point3d const& p) { return p.z < k.top; }) || none([&](Point3d const& p) { return p.z > k.bottom; }))
    return false;
  for (std::size_t i = 0; i < n; ++i) {
    Point2d const u = k.footprint[i], v = detail::footprint_point(k, i + 1);
    if (none([&](Point3d const& p) { return is_positive(orient2d<A>(u, v, horizontal(p))); })) return false;
  }
  if (detail::any_edge(t, [&](auto const& a, auto const& b, auto const& c) {
        return detail::vertical_plane_separates<A>(k, horizontal(a), horizontal(b), horizontal(c));
      }))
    return false;
  detail::OneSided side;
  for (auto const& v : k.footprint)
    for (double const z : {k.bottom, k.top})
      side.add(orient3d<A>(t.vertices[0], t.vertices[1], t.vertices[2], Point3d{v.x, v.y, z}));
  if (side.holds()) return false;
  for (std::size_t i = 0; i < n; ++i)
    for (Sign const cap : {Sign::negative, Sign::positive}) {
      double const z = is_positive(cap) ? k.top : k.bottom;
      Point2d const p = k.footprint[i], q = detail::footprint_point(k, i + 1);
      Point3d const u{p.x, p.y, z}, v{q.x, q.y, z};
      if (detail::any_edge(t, [&](auto const& a, auto const& b, auto const& c) {
            return detail::cap_edge_separates<A>(u, v, cap, a, b, c);
          }))
        return false;
    }
  return true;
}

/// The same for a polyhedron. Requires: the polyhedron's invariants.
template <Arithmetic A>
bool meets_interior(Triangle const& t, ConvexPolyhedron const& k)
{
  detail::OneSided side;
  for (auto const& v : k.vertices) side.add(orient3d<A>(t.vertices[0], t.vertices[1], t.vertices[2], v));
  if (side.holds()) return false;
  constexpr ConvexPolyhedron::Index none = -1;
  thread_local std::vector<std::array<ConvexPolyhedron::Index, 2>> opposite;  // the third vertices of an edge's facets
  opposite.assign(k.edges.size(), {none, none});
  for (auto const& f : k.facets) {
    auto const vertex = [&](std::size_t i) { return k.vertices[f.vertices[i]]; };
    if (std::ranges::none_of(
          t.vertices, [&](Point3d const& p) { return is_negative(orient3d<A>(vertex(0), vertex(1), vertex(2), p)); }))
      return false;
    for (std::size_t i = 0; i < 3; ++i) {
      auto const e = f.edges[i];
      auto& pair = opposite[static_cast<std::size_t>(e >= 0 ? e : ~e)];
      pair[pair[0] == none ? 0 : 1] = f.vertices[(i + 2) % 3];
    }
  }
  for (std::size_t e = 0; e < k.edges.size(); ++e) {
    Point3d const &u = k.vertices[k.edges[e].from], &v = k.vertices[k.edges[e].to];
    Point3d const &w = k.vertices[opposite[e][0]], &x = k.vertices[opposite[e][1]];
    if (detail::any_edge(t, [&](auto const& a, auto const& b, auto const& c) {
          return detail::edges_separate<A>(u, v, w, x, a, b, c);
        }))
      return false;
  }
  return true;
}

}  // namespace visibility
