#include "visibility/scene/exposed_lines.hpp"

#include "edge_cover.hpp"
#include "line_clip.hpp"
#include "top_plane.hpp"

#include <algorithm>

namespace visibility {

namespace {

using namespace height_field;
using NT = RationalNumber;

/// Whether the part has length in the interior of the polygon.
bool enters(Corners polygon, SeamPart const& part)
{
  Point2q const p = horizontal(part.left), q = horizontal(part.right);
  LineRange range{NT(0), NT(1)};
  range.clip(polygon, p, q);
  if (!range.has_length()) return false;
  Point2q const middle = horizontal(between(part.left, part.right, NT((*range.low + *range.high) / 2)));
  return !any_side(polygon, [&](Point3d const& c, Point3d const& d) {
    return turn(horizontal(exact(c)), horizontal(exact(d)), middle) <= 0;
  });
}

/// The part of a convex polygon inside another one, in plan.
std::vector<Point2q> intersection(Corners a, Corners b)
{
  std::vector<Point2q> part, kept;
  for (auto const& c : a) part.push_back(horizontal(exact(c)));
  any_side(b, [&](Point3d const& c, Point3d const& d) {
    Point2q const p = horizontal(exact(c)), q = horizontal(exact(d));
    kept.clear();
    for (std::size_t i = 0; i < part.size(); ++i) {
      Point2q const &x = part[i], &y = part[i + 1 < part.size() ? i + 1 : 0];
      NT const at_x = turn(p, q, x), at_y = turn(p, q, y);
      if (at_x >= 0) kept.push_back(x);
      if ((at_x > 0 && at_y < 0) || (at_x < 0 && at_y > 0)) {
        NT const t = at_x / (at_x - at_y);
        kept.push_back({x.x + t * (y.x - x.x), x.y + t * (y.y - x.y)});
      }
    }
    std::swap(part, kept);
    return false;
  });
  return part;
}

enum class At : std::uint8_t { covered, open, undecided };

/// Whether a column covers the top at the point; undecided on the border of one.
At look_at(HeightField const& field, Plane const& top, Point2q const& x)
{
  At out = At::open;
  Point3q const s{x.x, x.y, top.over(x)};
  field.column_hierarchy().any_item_meeting(reach(s, s), [&](std::uint32_t c) {
    auto const& column = field.columns()[c];
    if (column.is_curtain()) return false;
    bool inside = true, on_border = false;
    any_side(field.corners(column), [&](Point3d const& p, Point3d const& q) {
      NT const side = turn(horizontal(exact(p)), horizontal(exact(q)), x);
      on_border |= side == 0;
      return !(inside = side >= 0);
    });
    Plane const rise = top_plane(field, column) - top;
    NT const height = rise.over(x);
    if (!inside || height < 0) return false;
    if (height == 0 && rise.is_level()) return false;  // coinciding tops
    out = height > 0 && !on_border ? At::covered : out == At::open ? At::undecided : out;
    return out == At::covered;
  });
  return out;
}

/// Whether the top is exposed in the interior of the polygon. Requires: that it is or is not holds for nearly all
/// points of it, and it has area.
bool is_open_inside(HeightField const& field, Plane const& top, std::vector<Point2q> const& polygon)
{
  // Points on a curve that meets a line in few places.
  for (int k = 1;; ++k) {
    Point2q sum{0, 0};
    NT total = 0, weight = 1;
    for (auto const& p : polygon) {
      sum = {sum.x + weight * p.x, sum.y + weight * p.y};
      total += weight;
      weight *= NT(k) + NT(1) / NT(2);
    }
    At const at = look_at(field, top, {sum.x / total, sum.y / total});
    if (at != At::undecided) return at == At::open;
  }
}

}  // namespace

bool is_exposed_inside(HeightField const& field, Occludees const& occludees, std::uint32_t index,
                       std::span<ExposedLine const> sides, Corners polygon)
{
  auto const& piece = occludees.pieces()[index];
  auto const any_enters = [&](std::span<ExposedLine const> lines) {
    return std::ranges::any_of(lines, [&](ExposedLine const& l) { return enters(polygon, l.part); });
  };
  if (any_enters(sides)) return true;
  if (piece.is_wall()) return false;
  Corners const corners = occludees.corners(piece);
  if (separates(corners, polygon) || separates(polygon, corners)) return false;
  if (any_enters(exposed_seams(field, occludees, index))) return true;
  return is_open_inside(field, plane_of(corners), intersection(corners, polygon));
}

}  // namespace visibility
