#include "edge_cover.hpp"
#include "inside_polygon.hpp"
#include "top_plane.hpp"

#include "visibility/scene/exposed_object.hpp"
#include "visibility/scene/seams.hpp"

#include <algorithm>
#include <optional>
#include <ranges>

namespace visibility {

namespace {

using namespace height_field;
using NT = RationalNumber;

/// Whether the highest top over the point is one of the object's; undecided on the border of a column.
At look_at(HeightField const& field, std::uint32_t object, Point2q const& x)
{
  std::optional<NT> own, other;
  bool on_border = false;
  Point3q const low{x.x, x.y, NT(HeightField::bottomless)};
  field.column_hierarchy().any_item_meeting(reach(low, low), [&](std::uint32_t c) {
    auto const& column = field.columns()[c];
    if (column.is_curtain()) return false;
    bool const outside = any_side(field.corners(column), [&](Point3d const& p, Point3d const& q) {
      NT const side = turn(horizontal(exact(p)), horizontal(exact(q)), x);
      on_border |= side == 0;
      return side < 0;
    });
    if (outside) return false;
    NT const height = top_plane(field, column).over(x);
    auto& highest = column.object == object ? own : other;
    if (!highest || *highest < height) highest = height;
    return on_border;
  });
  return on_border ? At::undecided : !other || (own && *own >= *other) ? At::open : At::covered;
}

}  // namespace

bool is_exposed_inside(HeightField const& field, std::uint32_t object, std::span<Point3d const> polygon)
{
  auto const is_inside = [&](Point3d const& a, Point3d const& b) {
    return enters(polygon, horizontal(exact(a)), horizontal(exact(b)));
  };
  auto const is_seen = [&](std::uint32_t edge, Crossing crossing) {
    auto const& e = field.edges()[edge];
    auto const exposed = exposed_parts(field, edge, crossing);
    if (exposed.all) return true;
    Point3q const a = exact(e.a), b = exact(e.b);
    return std::ranges::any_of(exposed.parts, [&](OpenInterval const& part) {
      return enters(polygon, horizontal(between(a, b, part.low)), horizontal(between(a, b, part.high)));
    });
  };
  auto const edges = std::ranges::equal_range(field.edges(), object, {},
                                              [&](HeightField::TopEdge const& e) { return field.object_of(e); });
  for (auto const& e : edges) {
    auto const index = static_cast<std::uint32_t>(&e - field.edges().data());
    if (is_inside(e.a, e.b) && (is_seen(index, Crossing::entering) || is_seen(index, Crossing::leaving))) return true;
  }
  auto const columns = std::ranges::equal_range(field.columns(), object, {}, &HeightField::Column::object);
  for (auto const& column : columns) {
    Corners const corners = field.corners(column);
    if (column.is_curtain() || separates(corners, polygon) || separates(polygon, corners)) continue;
    auto const index = static_cast<std::uint32_t>(&column - field.columns().data());
    for (auto const& seam : std::ranges::equal_range(field.seams(), index, {}, &Seam::column))
      for (auto const& part : exposed_parts(field, seam))
        if (enters(polygon, horizontal(part.left), horizontal(part.right))) return true;
    if (is_open_inside(intersection(corners, polygon), [&](Point2q const& x) { return look_at(field, object, x); }))
      return true;
  }
  return false;
}

}  // namespace visibility
