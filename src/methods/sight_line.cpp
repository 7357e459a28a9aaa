#include "visibility/methods/exact_25d/sight_line.hpp"

#include "top_plane.hpp"

#include "visibility/predicates/orient2d.hpp"

#include <algorithm>

namespace visibility::exact_25d {

namespace {

using R = RationalNumber;

R turn(Point3d const& p, Point3d const& q, Point3q const& x)
{
  return detail::Orient2dFormula{}(R(p.x), R(p.y), R(q.x), R(q.y), x.x, x.y);
}

Point3q between(Point3q const& a, Point3q const& b, R const& t)
{
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

bool meets_curtain(Point3d const& a, Point3d const& b, Point3q const& from, Point3q const& to)
{
  R const at_from = turn(a, b, from), at_to = turn(a, b, to);
  if (at_from == at_to) return false;  // parallel; along the curtain is no generic line
  R const t = at_from / (at_from - at_to);
  if (t < 0 || t >= 1) return false;
  Point3q const p = between(from, to, t);
  // Where along the edge, by the coordinate in which it is longer.
  bool const along_x = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  R const u = along_x ? R((p.x - R(a.x)) / (R(b.x) - R(a.x))) : R((p.y - R(a.y)) / (R(b.y) - R(a.y)));
  return u >= 0 && u <= 1 && p.z <= R(a.z) + u * (R(b.z) - R(a.z));
}

bool is_inside(std::span<Point3d const> corners, Point3q const& p)
{
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (turn(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0], p) <= 0) return false;
  return true;
}

/// Whether the column meets [from, to).
bool meets(std::span<Point3d const> corners, bool is_flat, Point3q const& from, Point3q const& to)
{
  if (corners.size() == 2) return meets_curtain(corners[0], corners[1], from, to);
  R first = 0, last = 1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    auto const &a = corners[i], &b = corners[i + 1 < corners.size() ? i + 1 : 0];
    R const at_from = turn(a, b, from), at_to = turn(a, b, to);
    if (at_from < 0 && at_to < 0) return false;
    if (at_from < 0) first = std::max(first, R(at_from / (at_from - at_to)));
    if (at_to < 0) last = std::min(last, R(at_from / (at_from - at_to)));
  }
  if (first > last || first >= 1) return false;
  auto const above = [&](R const& t) -> R {
    Point3q const p = between(from, to, t);
    return is_flat ? R(p.z - R(corners[0].z)) : TopPlane(corners).above(p);
  };
  // Linear in between; at the end, which does not belong to the segment, it may touch.
  R const at_last = above(last);
  return above(first) <= 0 || (last < 1 ? at_last <= 0 : at_last < 0);
}

}  // namespace

bool is_free(HeightField const& field, Point3q const& from, Point3q const& to)
{
  auto const rounded = [](Point3q const& p) {
    return Point3d{CGAL::to_double(p.x), CGAL::to_double(p.y), CGAL::to_double(p.z)};
  };
  Point3d const p = rounded(from), q = rounded(to);
  SegmentProbe const probe(p, q);
  double const room =
    0x1p-50 * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z) + std::abs(q.x) + std::abs(q.y) + std::abs(q.z));
  Box along;
  along.extend(p);
  along.extend(q);
  bool free = true;
  field.column_hierarchy().front_to_back(
    along,
    [&](std::uint32_t, Box b) {
      b.min = {b.min.x - room, b.min.y - room, b.min.z};
      b.max = {b.max.x + room, b.max.y + room, b.max.z + room};
      return free && !probe.certainly_misses(b);
    },
    [&](std::uint32_t i) {
      auto const& column = field.columns()[i];
      if (free && meets(field.corners(column), column.is_flat, from, to)) free = false;
    });
  return free;
}

std::optional<Witness> witness(HeightField const& field, FoundLine const& line)
{
  auto const& column = field.columns()[line.column];
  R step(0x1p-8);
  for (int i = 0; i < 12; ++i, step = step * step) {
    Point3q low = line.end;
    low.z = low.z - step;
    Point3q to = low;
    if (line.sees_top) {
      // Where the line to the lowered end goes through the plane of the top.
      TopPlane const top(field.corners(column));
      R const at_from = top.above(line.from), at_end = top.above(low);
      if (!(at_from > 0 && at_end < 0)) continue;
      to = between(line.from, low, R(at_from / (at_from - at_end)));
    }
    // Above the ground, where the face of what the column was made from ends.
    else if (low.z <= field.ground() && line.end.z > field.ground())
      continue;
    if (line.sees_top && !is_inside(field.corners(column), to)) continue;
    if (is_free(field, line.from, to)) return Witness{column.object, line.from, to};
  }
  return {};
}

}  // namespace visibility::exact_25d
