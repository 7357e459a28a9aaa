#include "visibility/methods/exact_25d/sight_line.hpp"

#include "scene/top_plane.hpp"

#include "visibility/predicates/orient2d.hpp"

#include <algorithm>

namespace visibility::exact_25d {

namespace {

using R = RationalNumber;

R turn(Point3d const& p, Point3d const& q, Point3q const& x)
{
  return detail::Orient2dFormula{}(R(p.x), R(p.y), R(q.x), R(q.y), x.x, x.y);
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
bool meets(HeightField const& field, HeightField::Column const& column, Point3q const& from, Point3q const& to)
{
  auto const corners = field.corners(column);
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
  auto const top = height_field::top_plane(field, column);
  auto const above = [&](R const& t) -> R {
    Point3q const p = between(from, to, t);
    return p.z - top.over(horizontal(p));
  };
  // Linear in between; at the end, which does not belong to the segment, it may touch.
  R const at_last = above(last);
  return above(first) <= 0 || (last < 1 ? at_last <= 0 : at_last < 0);
}

}  // namespace

bool is_free(HeightField const& field, Point3q const& from, Point3q const& to)
{
  EnclosingProbe const probe(from, to);
  bool free = true;
  Box along;
  along.extend(visibility::detail::rounded(from));
  field.column_hierarchy().front_to_back(
    along, [&](std::uint32_t, Box const& b) { return free && !probe.certainly_misses(b); },
    [&](std::uint32_t i) { free = free && !meets(field, field.columns()[i], from, to); });
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
      auto const top = height_field::top_plane(field, column);
      R const at_from = line.from.z - top.over(horizontal(line.from)), at_end = low.z - top.over(horizontal(low));
      if (!(at_from > 0 && at_end < 0)) continue;
      to = between(line.from, low, R(at_from / (at_from - at_end)));
      if (!is_inside(field.corners(column), to)) continue;
    } else if (low.z <= field.ground() && line.end.z > field.ground()) {
      continue;  // the wall of what the column was made from ends at the ground
    }
    if (is_free(field, line.from, to)) return Witness{column.object, line.from, to};
  }
  return {};
}

}  // namespace visibility::exact_25d
