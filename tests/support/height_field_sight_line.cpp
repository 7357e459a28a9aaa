// Sight lines and contact with the cell, by clipping in rationals; knows nothing of the search.

#include "support/height_field_rational.hpp"

#include <algorithm>

namespace visibility::oracle {
namespace rational {

using NT = RationalNumber;

bool inside(std::vector<Point2q> const& convex, Point2q const& p)
{
  for (std::size_t i = 0, n = convex.size(); i < n; ++i)
    if (turn(convex[i], convex[(i + 1) % n], p) <= 0) return false;
  return true;
}

NT height(Column const& column, Point2q const& p)
{
  auto const& c = column.corners;
  Point2q const a = plan(c[0]);
  if (c.size() > 3) return NT(c[0].z);
  Point2q const b = plan(c[1]), d = plan(c[2]);
  return (turn(b, d, p) * NT(c[0].z) + turn(d, a, p) * NT(c[1].z) + turn(a, b, p) * NT(c[2].z)) / turn(a, b, d);
}

bool meets(Column const& column, Point3q const& p, Point3q const& s)
{
  NT first = 0, last = 1;
  bool empty = false;
  // Keep the t with f(t) >= 0, f linear with the given values at the ends.
  auto const keep = [&](NT const& at_p, NT const& at_s) {
    NT const slope = at_s - at_p;
    if (slope == 0) {
      empty = empty || at_p < 0;
    } else if (slope > 0) {
      first = std::max<NT>(first, -at_p / slope);
    } else {
      last = std::min<NT>(last, -at_p / slope);
    }
  };
  auto const corners = polygon(column.corners);
  for (std::size_t i = 0, n = corners.size(); i < n; ++i) {
    auto const &a = corners[i], &b = corners[(i + 1) % n];
    keep(turn(a, b, plan(p)), turn(a, b, plan(s)));
  }
  keep(height(column, plan(p)) - p.z, height(column, plan(s)) - s.z);
  return !empty && first <= last && first < 1;
}

}  // namespace rational
namespace {

using namespace rational;

/// Whether the point lies in the relative interior of a face of the column.
bool on_face(Column const& column, Point3q const& s)
{
  auto const corners = polygon(column.corners);
  Point2q const q = plan(s);
  NT const top = height(column, q);
  if (inside(corners, q)) return s.z == top;
  if (s.z >= top) return false;
  for (std::size_t i = 0, n = corners.size(); i < n; ++i) {
    auto const &a = corners[i], &b = corners[(i + 1) % n];
    if (!column.inner.empty() && column.inner[i]) continue;
    if (turn(a, b, q) != 0) continue;
    NT const along = (q.x - a.x) * (b.x - a.x) + (q.y - a.y) * (b.y - a.y);
    if (along > 0 && along < (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)) return true;
  }
  return false;
}

/// What the closed convex polygons have in common: a polygon, perhaps flat, perhaps empty.
std::vector<Point2q> common(std::vector<Point2q> subject, std::vector<Point2q> const& clip)
{
  for (std::size_t i = 0, n = clip.size(); i < n; ++i) {
    auto const &a = clip[i], &b = clip[(i + 1) % n];
    std::vector<Point2q> kept;
    for (std::size_t j = 0; j < subject.size(); ++j) {
      auto const &p = subject[j], &q = subject[(j + 1) % subject.size()];
      NT const fp = turn(a, b, p), fq = turn(a, b, q);
      if (fp >= 0) kept.push_back(p);
      if ((fp > 0 && fq < 0) || (fp < 0 && fq > 0)) {
        NT const t = fp / (fp - fq);
        kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
      }
    }
    subject = std::move(kept);
  }
  return subject;
}

bool has_area(std::vector<Point2q> const& ring)
{
  NT sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += turn(ring[0], ring[i], ring[i + 1]);
  return sum > 0;
}

void require_convex(std::vector<Point2q> const& ring)
{
  std::size_t const n = ring.size();
  require(n >= 3 && has_area(ring), "a polygon must be counterclockwise with area");
  for (std::size_t i = 0; i < n; ++i) {
    require(ring[i] != ring[(i + 1) % n], "a polygon repeats a corner");
    for (std::size_t j = 0; j < n; ++j)
      require(turn(ring[i], ring[(i + 1) % n], ring[j]) >= 0, "a polygon must be convex");
  }
}

}  // namespace

bool meets(Column const& column, Cell const& cell)
{
  for (auto const& p : common(polygon(column.corners), polygon(cell.footprint)))
    if (height(column, p) >= NT(cell.bottom)) return true;
  return false;
}

bool confirms(std::span<Column const> columns, Cell const& cell, Witness const& witness)
{
  auto const &p = witness.from, &s = witness.to;
  if (!inside(polygon(cell.footprint), plan(p)) || p.z <= NT(cell.bottom) || p.z >= NT(cell.top)) return false;
  bool on_object = false;
  for (auto const& c : columns) {
    on_object = on_object || (c.object == witness.object && on_face(c, s));
    if (meets(c, p, s)) return false;
  }
  return on_object && p != s;
}

void validate(std::span<Column const> columns, std::size_t object_count, Cell const& cell)
{
  for (auto const& p : cell.footprint) require(is_finite(p), "the cell must be finite");
  require_convex(polygon(cell.footprint));
  require(cell.bottom < cell.top, "the cell's bottom must lie below its top");
  require(columns.size() <= 60, "too many columns");
  for (auto const& c : columns) {
    for (auto const& p : c.corners) require(is_finite(p), "a column must be finite");
    auto const ring = polygon(c.corners);
    require_convex(ring);
    require(c.object < object_count, "a column's object is not there");
    require(c.inner.empty() || c.inner.size() == c.corners.size(), "one flag per side");
    if (c.corners.size() > 3)
      for (auto const& p : c.corners) require(p.z == c.corners[0].z, "only triangles may have slanted tops");
    auto const in_cell = common(ring, polygon(cell.footprint));
    if (has_area(in_cell))
      for (auto const& p : in_cell) require(height(c, p) < NT(cell.top), "a column reaches the cell's top inside it");
  }
}

}  // namespace visibility::oracle
