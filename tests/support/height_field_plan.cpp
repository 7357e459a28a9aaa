#include "support/height_field_plan.hpp"

#include <algorithm>
#include <cmath>

namespace visibility::oracle::detail {
namespace {

/// A power of two about as large as the scene in plan.
double extent(std::span<Column const> columns, Cell const& cell, std::span<Point3d const> target)
{
  double reach = 0;
  auto const& o = cell.footprint[0];
  auto const include = [&](auto const& points) {
    for (auto const& p : points) reach = std::max({reach, std::fabs(p.x - o.x), std::fabs(p.y - o.y)});
  };
  include(cell.footprint), include(target);
  for (auto const& c : columns) include(c.corners);
  return std::ldexp(1.0, std::clamp(std::ilogb(reach), -1000, 1000));
}

/// The point common to two lines that are not parallel, with z > 0.
Vector meet(Vector const& k, Vector const& l)
{
  Vector const p = cross(k, l);
  return p.z < 0 ? -p : p;
}

/// Whether the point of the segment's line lies on the closed segment.
bool on(Segment const& s, Vector const& p)
{
  Vector const across{-s.line.y, s.line.x, NT(0)};  // grows along the segment, up to a factor; compare with the ends
  NT const at_p = dot(across, p), at_a = dot(across, s.a), at_b = dot(across, s.b);
  NT const from_a = at_p * s.a.z - at_a * p.z, from_b = at_p * s.b.z - at_b * p.z;
  return sign(from_a) * sign(from_b) <= 0;
}

}  // namespace

Plan::Plan(std::span<Column const> input, Cell const& cell, std::span<Point3d const> target)
  : origin(cell.footprint[0]), unit(extent(input, cell, target)), columns(static_cast<int>(input.size()))
{
  for (auto const& c : input) {
    std::vector<Vector> corners;
    for (auto const& p : c.corners) corners.push_back(point(p.x, p.y));
    add_polygon(corners, top_of(c.corners), c.inner);
  }
  std::vector<Vector> corners;
  for (auto const& p : cell.footprint) corners.push_back(point(p.x, p.y));
  add_polygon(corners, {{NT(0), NT(0), NT(cell.top)}, NT(1)}, {});

  if (!target.empty()) add_target(target);

  first_ridge = static_cast<int>(segments.size());
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < i; ++j) add_ridge(i, j);
  if (!target.empty())
    for (int j = 0; j < columns; ++j)
      is_fence(this->target()) ? add_piercing(this->target(), j) : add_ridge(this->target(), j);
  add_crossings();
}

/// The plane of a polygon with area in plan.
Plane Plan::top_of(std::span<Point3d const> c) const
{
  if (std::ranges::all_of(c, [&](Point3d const& p) { return p.z == c[0].z; }))
    return {{NT(0), NT(0), NT(c[0].z)}, NT(1)};
  Vector const first = point(c[0].x, c[0].y);
  auto const from_first = [&](Point3d const& q) {
    Vector const p = point(q.x, q.y);
    return Vector{p.x - first.x, p.y - first.y, NT(q.z) - NT(c[0].z)};
  };
  std::size_t k = 1;  // the first corners may lie on one side
  Vector n = cross(from_first(c[1]), from_first(c[2]));
  while (n.z == 0 && k + 2 < c.size()) ++k, n = cross(from_first(c[k]), from_first(c[k + 1]));
  return {{-n.x, -n.y, dot(n, {first.x, first.y, NT(c[0].z)})}, n.z};
}

/// A plane through the edge: that level across it.
Plane Plan::top_of_fence(Point3d const& a, Point3d const& b) const
{
  Vector const p = point(a.x, a.y), q = point(b.x, b.y);
  NT const x = q.x - p.x, y = q.y - p.y, rise = NT(b.z) - NT(a.z), length_sq = x * x + y * y;
  return {{rise * x, rise * y, NT(a.z) * length_sq - rise * (x * p.x + y * p.y)}, length_sq};
}

void Plan::add_target(std::span<Point3d const> target)
{
  std::vector<Vector> corners;
  for (auto const& p : target) corners.push_back(point(p.x, p.y));
  if (target.size() > 2) return add_polygon(corners, top_of(target), {});
  Polygons const owner = polygon_bit(static_cast<int>(polygons.size()));
  first_side.push_back(static_cast<int>(segments.size()));
  segments.push_back({corners[0], corners[1], cross(corners[0], corners[1]), owner});
  for (auto const& c : corners) events.push_back({c, owner});
  polygons.push_back(corners);
  tops.push_back(top_of_fence(target[0], target[1]));
}

void Plan::add_polygon(std::vector<Vector> const& corners, Plane const& top, std::vector<bool> const& inner)
{
  Polygons const owner = polygon_bit(static_cast<int>(polygons.size()));
  first_side.push_back(static_cast<int>(segments.size()));
  for (std::size_t k = 0, n = corners.size(); k < n; ++k) {
    auto const &a = corners[k], &b = corners[(k + 1) % n];
    segments.push_back({a, b, cross(a, b), owner, inner.empty() || !inner[k]});
    events.push_back({a, owner});
  }
  polygons.push_back(corners);
  tops.push_back(top);
}

/// Whether the closed polygon with area holds the point.
bool Plan::in(int polygon, Vector const& point) const
{
  for (int k = 0; k < side_count(polygon); ++k)
    if (dot(segments[std::size_t(first_side[std::size_t(polygon)] + k)].line, point) < 0) return false;
  return true;
}

/// Where the upper edge of a fence pierces a column's top: a point.
void Plan::add_piercing(int fence, int column)
{
  auto const &p = tops[std::size_t(fence)], &q = tops[std::size_t(column)];
  auto const& side = segments[std::size_t(first_side[std::size_t(fence)])];
  Vector const x = meet((q.scale * p.form) + (-(p.scale * q.form)), side.line);
  if (x.z != 0 && on(side, x) && in(column, x)) events.push_back({x, side.owners | polygon_bit(column)});
}

/// Where the tops of two polygons have the same height over both.
void Plan::add_ridge(int i, int j)
{
  auto const &p = tops[std::size_t(i)], &q = tops[std::size_t(j)];
  Vector line = (q.scale * p.form) + (-(p.scale * q.form));
  if (line.x == 0 && line.y == 0) return;
  Polygons const owners = polygon_bit(i) | polygon_bit(j);
  std::vector<Vector> ends;
  for (int polygon : {i, j})
    for (int k = 0; k < side_count(polygon); ++k) {
      auto const& side = segments[std::size_t(first_side[std::size_t(polygon)] + k)].line;
      Vector const x = meet(line, side);
      if (x.z != 0 && in(i, x) && in(j, x)) ends.push_back(x);
    }
  auto const along = [&](Vector const& a, Vector const& b) -> NT {  // positive iff b comes after a
    return (b.y * a.z - a.y * b.z) * line.x - (b.x * a.z - a.x * b.z) * line.y;
  };
  auto const before = [&](Vector const& a, Vector const& b) { return along(a, b) > 0; };
  if (ends.empty()) return;
  auto const [a, b] = std::ranges::minmax_element(ends, before);
  if (along(*a, *b) == 0) {  // they touch there: what is higher along the common side changes
    events.push_back({*a, owners});
    return;
  }
  Segment ridge{*a, *b, line, owners, false};
  if (dot(cross(ridge.a, ridge.b), line) < 0) ridge.line = -line;
  segments.push_back(ridge);
  events.push_back({ridge.a, owners});
  events.push_back({ridge.b, owners});
}

void Plan::add_crossings()
{
  for (auto const& s : segments)
    for (auto const& t : segments) {
      if (&t == &s) break;
      Vector const x = meet(s.line, t.line);
      if (x.z != 0 && s.owners != t.owners && on(s, x) && on(t, x)) events.push_back({x, s.owners | t.owners});
    }
}

}  // namespace visibility::oracle::detail
