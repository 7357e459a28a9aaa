// Convex polygons in space: contact with the cell, sight lines that end on them, and what they look like in plan.

#include "support/height_field_polygon.hpp"

#include "support/height_field_rational.hpp"

#include <algorithm>

namespace visibility::oracle {
namespace {

using NT = RationalNumber;
using rational::plan, rational::require, rational::turn;

Point3q minus(Point3q const& a, Point3q const& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
NT dot(Point3q const& a, Point3q const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3q cross(Point3q const& a, Point3q const& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

std::vector<Point3q> exact_ring(detail::Polygon const& polygon)
{
  std::vector<Point3q> ring;
  for (auto const& p : polygon) ring.push_back(exact(p));
  return ring;
}

/// Normal to the polygon, about which it turns counterclockwise, twice its area long; zero if it has none.
Point3q normal(std::vector<Point3q> const& ring)
{
  Point3q sum{NT(0), NT(0), NT(0)};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    Point3q const n = cross(minus(ring[i], ring[0]), minus(ring[i + 1], ring[0]));
    sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
  }
  return sum;
}

bool is_zero(Point3q const& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// Positive iff p lies on the polygon's side of the side from corner i, zero on it. Requires: p in the polygon's plane.
NT side(std::vector<Point3q> const& ring, Point3q const& n, std::size_t i, Point3q const& p)
{
  auto const &a = ring[i], &b = ring[(i + 1) % ring.size()];
  return dot(n, cross(minus(b, a), minus(p, a)));
}

bool in_relative_interior(detail::Polygon const& polygon, Point3q const& p)
{
  auto const ring = exact_ring(polygon);
  Point3q const n = normal(ring);
  if (is_zero(n) || dot(n, minus(p, ring[0])) != 0) return false;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i] != ring[(i + 1) % ring.size()] && side(ring, n, i, p) <= 0) return false;
  return true;
}

/// The part of the ring where f >= 0, f linear.
template <class F>
std::vector<Point3q> clipped(std::vector<Point3q> const& ring, F const& f)
{
  std::vector<Point3q> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    auto const &p = ring[i], &q = ring[(i + 1) % ring.size()];
    NT const at_p = f(p), at_q = f(q);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      NT const t = at_p / (at_p - at_q);
      kept.push_back(between(p, q, t));
    }
  }
  return kept;
}

bool meets(detail::Polygon const& polygon, Cell const& cell)
{
  auto ring = exact_ring(polygon);
  if (is_zero(normal(ring))) return false;
  ring = clipped(ring, [&](Point3q const& p) -> NT { return p.z - NT(cell.bottom); });
  ring = clipped(ring, [&](Point3q const& p) -> NT { return NT(cell.top) - p.z; });
  for (std::size_t i = 0, n = cell.footprint.size(); i < n; ++i) {
    Point2q const a = plan(cell.footprint[i]), b = plan(cell.footprint[(i + 1) % n]);
    ring = clipped(ring, [&](Point3q const& p) { return turn(a, b, plan(p)); });
  }
  return !ring.empty();
}

/// The upper edges of a vertical polygon that are not upright, from end to end.
std::vector<detail::Polygon> upper_edges(detail::Polygon const& polygon)
{
  bool const along_x = std::ranges::any_of(polygon, [&](Point3d const& p) { return p.x != polygon[0].x; });
  auto const place = [&](Point3d const& p) { return NT(along_x ? p.x : p.y); };
  std::vector<detail::Polygon> edges;
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    auto a = polygon[i], b = polygon[(i + 1) % n];
    if (place(a) == place(b)) continue;
    if (place(a) > place(b)) std::swap(a, b);
    bool const upper = std::ranges::all_of(polygon, [&](Point3d const& p) {
      return (NT(b.z) - NT(a.z)) * (place(p) - place(a)) >= (NT(p.z) - NT(a.z)) * (place(b) - place(a));
    });
    if (upper) edges.push_back({a, b});
  }
  return edges;
}

}  // namespace

bool meets(Occludee const& occludee, Cell const& cell)
{
  return std::ranges::any_of(occludee.polygons, [&](auto const& p) { return meets(p, cell); });
}

bool confirms(std::span<Column const> columns, Occludee const& occludee, Cell const& cell, Witness const& witness)
{
  auto const &p = witness.from, &s = witness.to;
  return rational::inside(rational::polygon(cell.footprint), plan(p)) && p.z > NT(cell.bottom) && p.z < NT(cell.top) &&
         p != s && std::ranges::none_of(columns, [&](Column const& c) { return rational::meets(c, p, s); }) &&
         std::ranges::any_of(occludee.polygons, [&](auto const& polygon) { return in_relative_interior(polygon, s); });
}

void validate(Occludee const& occludee)
{
  for (auto const& polygon : occludee.polygons) {
    for (auto const& p : polygon) require(is_finite(p), "an occludee must be finite");
    auto const ring = exact_ring(polygon);
    Point3q const n = normal(ring);
    if (is_zero(n)) continue;
    for (auto const& p : ring) {
      require(dot(n, minus(p, ring[0])) == 0, "an occludee's polygons must be planar");
      for (std::size_t i = 0; i < ring.size(); ++i)
        require(side(ring, n, i, p) >= 0, "an occludee's polygons must be convex");
    }
  }
}

namespace detail {

bool has_area(Polygon const& polygon) { return !is_zero(normal(exact_ring(polygon))); }

std::vector<Polygon> targets(Polygon const& polygon)
{
  NT const up = normal(exact_ring(polygon)).z;
  if (up == 0) return upper_edges(polygon);
  Polygon ring;
  for (auto const& p : polygon)
    if (ring.empty() || p != ring.back()) ring.push_back(p);
  if (ring.back() == ring[0]) ring.pop_back();
  if (up < 0) std::ranges::reverse(ring);
  return {ring};
}

}  // namespace detail
}  // namespace visibility::oracle
