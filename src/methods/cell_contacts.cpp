#include "visibility/methods/exact_25d/cell_contacts.hpp"

#include "scene/polygon_sides.hpp"

#include "visibility/scene/exposed_object.hpp"

#include <algorithm>
#include <array>

namespace visibility::exact_25d {

namespace {

using height_field::Corners;

bool closures_meet(Corners a, Corners b)
{
  return !height_field::separates_strictly(a, b) && !height_field::separates_strictly(b, a);
}
bool interiors_meet(Corners a, Corners b) { return !height_field::separates(a, b) && !height_field::separates(b, a); }

/// The greatest height of a column's top over the part of it inside the outline. Requires: their closures meet.
RationalNumber highest_inside(Corners corners, Corners outline)
{
  std::vector<Point3q> part;
  for (auto const& c : corners) part.push_back(exact(c));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Point2q const p{outline[i].x, outline[i].y};
    auto const& next = outline[i + 1 < outline.size() ? i + 1 : 0];
    Point2q const q{next.x, next.y};
    auto const side = [&](Point3q const& x) {
      return RationalNumber(detail::Orient2dFormula{}(p.x, p.y, q.x, q.y, x.x, x.y));
    };
    std::vector<Point3q> kept;
    for (std::size_t k = 0; k < part.size(); ++k) {
      Point3q const &a = part[k], &b = part[k + 1 < part.size() ? k + 1 : 0];
      RationalNumber const sa = side(a), sb = side(b);
      if (sa >= 0) kept.push_back(a);
      if ((sa > 0 && sb < 0) || (sa < 0 && sb > 0)) {
        RationalNumber const t = sa / (sa - sb);
        kept.push_back(between(a, b, t));
      }
    }
    part = std::move(kept);
  }
  RationalNumber best = part.empty() ? RationalNumber(HeightField::bottomless) : part.front().z;
  for (auto const& p : part) best = std::max(best, p.z);
  return best;
}

/// Whether the cell is a prism with a level top and bottom.
bool is_upright(ViewCell const& cell, CellOutline const& outline)
{
  auto const& v = cell.vertices();
  return outline.flat && v.size() == 2 * outline.size() && std::ranges::all_of(outline.corners, [&](Point3d const& c) {
           return std::ranges::find(v, Point3d{c.x, c.y, outline.bottom}) != v.end();
         });
}

}  // namespace

CellContacts cell_contacts(HeightField const& field, ViewCell const& cell, CellOutline const& outline)
{
  CellContacts out;
  Corners const footprint = outline.corners;
  Box under = cell.bounds();
  under.min.z = -HUGE_VAL;
  under.max.z = HUGE_VAL;
  bool const upright = is_upright(cell, outline);
  std::vector<bool> visible(field.scene().objects.size());
  std::vector<std::uint32_t> intruders, below;
  field.column_hierarchy().any_meeting(under, [&](std::uint32_t i) {
    auto const& column = field.columns()[i];
    Corners const corners = field.corners(column);
    if (!closures_meet(footprint, corners)) return false;
    bool const overlaps = interiors_meet(footprint, corners);
    RationalNumber const height = column.is_flat ? RationalNumber(corners[0].z) : highest_inside(corners, footprint);
    if (height >= outline.bottom) {
      visible[column.object] = true;
      if (!upright) out.exact = false;  // it may pass below or beside the cell
      if (overlaps && (!upright || height >= outline.top)) intruders.push_back(i);
    } else if (overlaps) {
      below.push_back(column.object);
    }
    return false;
  });
  if (!intruders.empty()) {
    out.exact = out.all_occlude = false;
    std::ranges::sort(intruders);
    field.edge_hierarchy().any_meeting(under, [&](std::uint32_t e) {
      auto const& edge = field.edges()[e];
      if (std::ranges::binary_search(intruders, edge.column) && interiors_meet(footprint, std::array{edge.a, edge.b}))
        out.ignored_edges.push_back(e);
      return false;
    });
    std::ranges::sort(out.ignored_edges);
  }
  std::ranges::sort(below);
  below.erase(std::unique(below.begin(), below.end()), below.end());
  for (auto const o : below) visible[o] = visible[o] || is_exposed_inside(field, o, footprint);
  for (std::uint32_t o = 0; o < visible.size(); ++o)
    if (visible[o]) out.visible.push_back(o);
  return out;
}

}  // namespace visibility::exact_25d
