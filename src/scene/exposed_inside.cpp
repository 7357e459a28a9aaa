#include "edge_cover.hpp"
#include "inside_polygon.hpp"
#include "top_plane.hpp"

#include "visibility/scene/exposed_lines.hpp"

#include <algorithm>

namespace visibility {

namespace {

using namespace height_field;
using NT = RationalNumber;

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

}  // namespace

bool is_exposed_inside(HeightField const& field, Occludees const& occludees, std::uint32_t index,
                       std::span<ExposedLine const> sides, Corners polygon)
{
  auto const& piece = occludees.pieces()[index];
  auto const any_enters = [&](std::span<ExposedLine const> lines) {
    return std::ranges::any_of(
      lines, [&](ExposedLine const& l) { return enters(polygon, horizontal(l.part.left), horizontal(l.part.right)); });
  };
  if (any_enters(sides)) return true;
  if (piece.is_wall()) return false;
  Corners const corners = occludees.corners(piece);
  if (separates(corners, polygon) || separates(polygon, corners)) return false;
  if (any_enters(exposed_seams(field, occludees, index))) return true;
  Plane const top = plane_of(corners);
  return is_open_inside(intersection(corners, polygon), [&](Point2q const& x) { return look_at(field, top, x); });
}

}  // namespace visibility
