#include "visibility/evidence/face.hpp"
#include "visibility/geometry/segment_coplanar.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>

/// Membership in the relative interior of a face, with rationals alone.
namespace visibility {

namespace {

bool in_box_face(Box const& b, Point3q const& p)
{
  auto const inside = [](RationalNumber const& v, double lo, double hi) {
    return RationalNumber(lo) < v && v < RationalNumber(hi);
  };
  auto const at = [](RationalNumber const& v, double lo, double hi) {
    return v == RationalNumber(lo) || v == RationalNumber(hi);
  };
  bool const x = inside(p.x, b.min.x, b.max.x), y = inside(p.y, b.min.y, b.max.y), z = inside(p.z, b.min.z, b.max.z);
  return (y && z && at(p.x, b.min.x, b.max.x)) || (x && z && at(p.y, b.min.y, b.max.y)) ||
         (x && y && at(p.z, b.min.z, b.max.z));
}

Point2q plane(Point2d const& p) { return {RationalNumber(p.x), RationalNumber(p.y)}; }

/// Whether p lies on the segment ab; its ends count iff `closed`.
bool on_segment(Point2d const& a0, Point2d const& b0, Point2q const& p, bool closed)
{
  Point2q const a = plane(a0), b = plane(b0);
  if (a == b) return closed && p == a;
  if (!is_zero(orient2d<Rational>(a, b, p))) return false;
  if (p == a || p == b) return closed;
  auto const between = [](RationalNumber const& v, RationalNumber const& s, RationalNumber const& t) {
    return std::min(s, t) <= v && v <= std::max(s, t);
  };
  return between(p.x, a.x, b.x) && between(p.y, a.y, b.y);
}

template <class Visit>
bool any_ring_edge(Prism const& prism, Visit&& visit)
{
  for (auto const& ring : prism.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (visit(ring[i], ring[(i + 1) % ring.size()])) return true;
  return false;
}

bool in_wall(Prism const& prism, Point3q const& p)
{
  if (!(RationalNumber(prism.bottom) < p.z && p.z < RationalNumber(prism.top))) return false;
  return any_ring_edge(prism, [&](auto const& a, auto const& b) { return on_segment(a, b, horizontal(p), false); });
}

bool in_footprint(ConvexPrism const& piece, Point2q const& p)
{
  for (std::size_t i = 0, n = piece.footprint.size(); i < n; ++i)
    if (is_negative(orient2d<Rational>(plane(piece.footprint[i]), plane(piece.footprint[(i + 1) % n]), p)))
      return false;
  return true;
}

bool in_cap(ConvexPrism const& piece, Point3q const& p)
{
  return (p.z == RationalNumber(piece.bottom) || p.z == RationalNumber(piece.top)) &&
         in_footprint(piece, horizontal(p));
}

/// Inside a face made of one or more coplanar facets: on one facet's plane and strictly inside all other planes.
bool in_facet(ConvexPolyhedron const& body, Point3q const& p)
{
  auto const side = [&](ConvexPolyhedron::Facet const& f, Point3q const& x) {
    auto const v = [&](std::size_t i) { return exact(body.vertices[f.vertices[i]]); };
    return orient3d<Rational>(v(0), v(1), v(2), x);
  };
  auto const coplanar = [&](ConvexPolyhedron::Facet const& f, ConvexPolyhedron::Facet const& g) {
    return std::ranges::all_of(g.vertices, [&](auto i) { return is_zero(side(f, exact(body.vertices[i]))); });
  };
  auto const on = std::ranges::find_if(body.facets, [&](auto const& f) { return is_zero(side(f, p)); });
  return on != body.facets.end() &&
         std::ranges::all_of(body.facets, [&](auto const& g) { return is_negative(side(g, p)) || coplanar(*on, g); });
}

bool in_triangle(Triangle const& t, Point3q const& p)
{
  Box const box = bounding_box(t);
  if (p.x < box.min.x || p.x > box.max.x || p.y < box.min.y || p.y > box.max.y || p.z < box.min.z || p.z > box.max.z)
    return false;
  Point3q const a = exact(t.vertices[0]), b = exact(t.vertices[1]), c = exact(t.vertices[2]);
  int const axis = detail::projection_axis<Rational>(a, b, c);
  if (axis < 0 || !is_zero(orient3d<Rational>(a, b, c, p))) return false;
  auto const A = detail::drop(axis, a), B = detail::drop(axis, b), C = detail::drop(axis, c), P = detail::drop(axis, p);
  Sign const turn = orient2d<Rational>(A, B, C);
  return orient2d<Rational>(A, B, P) == turn && orient2d<Rational>(B, C, P) == turn &&
         orient2d<Rational>(C, A, P) == turn;
}

bool on_sphere(Ball const& ball, Point3q const& p)
{
  RationalNumber const r(ball.radius), x = p.x - RationalNumber(ball.centre.x), y = p.y - RationalNumber(ball.centre.y),
                                       z = p.z - RationalNumber(ball.centre.z);
  return r > 0 && x * x + y * y + z * z == r * r;
}

}  // namespace

bool in_face_interior(PreparedScene const& scene, std::uint32_t object, Point3q const& p)
{
  Scene const& s = scene.scene();
  Object const& o = s.objects[object];
  auto const any = [](IndexRange range, auto&& test) {
    for (auto i = range.first; i < range.last; ++i)
      if (test(i)) return true;
    return false;
  };
  auto const on_ring = [&](std::uint32_t i) {
    return any_ring_edge(s.prisms[i],
                         [&](auto const& a, auto const& b) { return on_segment(a, b, horizontal(p), true); });
  };
  // Roofs and floors: inside a closed convex piece, on no ring edge.
  auto const in_caps = [&] {
    return std::ranges::any_of(scene.bodies().bodies_of(object), [&](ConvexBodies::Body const& b) {
      return b.kind == ConvexBodies::Kind::prism && in_cap(scene.bodies().prism(b), p);
    });
  };
  return any(o.boxes, [&](auto i) { return in_box_face(s.boxes[i], p); }) ||
         any(o.balls, [&](auto i) { return on_sphere(s.balls[i], p); }) ||
         any(o.prisms, [&](auto i) { return in_wall(s.prisms[i], p); }) || (in_caps() && !any(o.prisms, on_ring)) ||
         any(o.polyhedra, [&](auto i) { return in_facet(s.polyhedra[i], p); }) ||
         any(o.triangles, [&](auto i) { return in_triangle(s.triangle(i), p); });
}

}  // namespace visibility
