#include "visibility/scene/meets_cell.hpp"

#include "visibility/predicates/orient3d.hpp"

#include <algorithm>

namespace visibility {

namespace {

using Bodies = ConvexBodies;

bool edge_meets(ViewCell const& cell, Point3d const& a, Point3d const& b)
{
  return a == b ? contains(cell, a) : segment_meets<Filtered>(cell.shape(), a, b);
}

/// Whether an edge of the body meets the cell. A box or triangle may be flat, down to a point.
bool any_edge_meets(ViewCell const& cell, Bodies const& bodies, Bodies::Body const& body)
{
  using Kind = Bodies::Kind;
  switch (body.kind) {
  case Kind::box: {
    auto const c = bodies.box(body).corners();
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t const bit : {1U, 2U, 4U})
        if ((i & bit) == 0 && edge_meets(cell, c[i], c[i | bit])) return true;
    return false;
  }
  case Kind::prism: {
    auto const& p = bodies.prism(body);
    for (std::size_t i = 0, n = p.footprint.size(); i < n; ++i) {
      auto const &a = p.footprint[i], &b = p.footprint[(i + 1) % n];
      if (edge_meets(cell, {a.x, a.y, p.bottom}, {b.x, b.y, p.bottom}) ||
          edge_meets(cell, {a.x, a.y, p.top}, {b.x, b.y, p.top}) ||
          edge_meets(cell, {a.x, a.y, p.bottom}, {a.x, a.y, p.top}))
        return true;
    }
    return false;
  }
  case Kind::polyhedron: {
    auto const& p = bodies.polyhedron(body);
    return std::ranges::any_of(p.edges,
                               [&](auto const& e) { return edge_meets(cell, p.vertices[e.from], p.vertices[e.to]); });
  }
  case Kind::triangle: {
    auto const& v = bodies.triangle(body).vertices;
    return edge_meets(cell, v[0], v[1]) || edge_meets(cell, v[1], v[2]) || edge_meets(cell, v[2], v[0]);
  }
  case Kind::ball: return contains(cell, bodies.ball(body).centre);
  }
  return false;
}

struct Vector {
  RationalNumber x, y, z;
};
Vector operator-(Point3q const& a, Point3q const& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RationalNumber dot(Vector const& a, Vector const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(Vector const& a, Vector const& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Whether the ball reaches the facet right above the centre's foot, which lies in the facet.
bool reaches_facet(Ball const& ball, Point3d const& a0, Point3d const& b0, Point3d const& c0)
{
  Point3q const a = exact(a0), b = exact(b0), c = exact(c0), m = exact(ball.centre);
  Vector const n = cross(b - a, c - a);
  RationalNumber const nn = dot(n, n), d = dot(m - a, n), r(ball.radius);
  if (d * d > r * r * nn) return false;
  RationalNumber const t = d / nn;
  Point3q const foot{m.x - t * n.x, m.y - t * n.y, m.z - t * n.z};
  auto const inside = [&](Point3q const& u, Point3q const& v) { return dot(cross(v - u, foot - u), n) >= 0; };
  return inside(a, b) && inside(b, c) && inside(c, a);
}

bool ball_reaches_facet(ViewCell const& cell, Ball const& ball)
{
  auto const& s = cell.shape();
  return std::ranges::any_of(s.facets, [&](ConvexPolyhedron::Facet const& f) {
    return reaches_facet(ball, s.vertices[f.vertices[0]], s.vertices[f.vertices[1]], s.vertices[f.vertices[2]]);
  });
}

/// Two convex polytopes share a point iff an edge of one meets the other: a vertex of the intersection lies on an edge
/// of one of them. For a ball one looks at the point of the cell nearest to the centre.
bool body_meets_cell(ViewCell const& cell, Bodies const& bodies, Bodies::Body const& body)
{
  if (any_edge_meets(cell, bodies, body)) return true;
  auto const& s = cell.shape();
  if (std::ranges::any_of(s.edges, [&](ConvexPolyhedron::Edge const& e) {
        return segment_meets<Filtered>(bodies, body, s.vertices[e.from], s.vertices[e.to]);
      }))
    return true;
  return body.kind == Bodies::Kind::ball && ball_reaches_facet(cell, bodies.ball(body));
}

/// A prism that is no solid consists of its walls.
bool walls_meet_cell(ViewCell const& cell, Prism const& prism)
{
  auto const& s = cell.shape();
  for (auto const& ring : prism.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      auto const &a = ring[i], &b = ring[(i + 1) % ring.size()];
      Point3d const a0{a.x, a.y, prism.bottom}, b0{b.x, b.y, prism.bottom}, b1{b.x, b.y, prism.top},
        a1{a.x, a.y, prism.top};
      if (edge_meets(cell, a0, b0) || edge_meets(cell, b0, b1) || edge_meets(cell, a1, b1) || edge_meets(cell, a0, a1))
        return true;
      if (std::ranges::any_of(s.edges, [&](ConvexPolyhedron::Edge const& e) {
            auto const &p = s.vertices[e.from], &q = s.vertices[e.to];
            return segment_meets<Filtered>(a0, b0, b1, p, q) || segment_meets<Filtered>(a0, b1, a1, p, q);
          }))
        return true;
    }
  return false;
}

}  // namespace

bool meets_cell(PreparedScene const& scene, ViewCell const& cell, std::uint32_t object)
{
  if (!meet(scene.object_bounds()[object], cell.bounds())) return false;
  auto const& bodies = scene.bodies();
  bool unsound = false;
  for (auto const& body : bodies.bodies_of(object)) {
    if (bodies.is_stand_in(body))
      unsound = true;
    else if (body_meets_cell(cell, bodies, body))
      return true;
  }
  if (!unsound) return false;
  auto const& o = scene.scene().objects[object];
  for (auto i = o.prisms.first; i < o.prisms.last; ++i)
    if (walls_meet_cell(cell, scene.scene().prisms[i])) return true;
  return false;
}

}  // namespace visibility
