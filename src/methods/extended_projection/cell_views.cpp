#include "visibility/methods/extended_projection/cell_views.hpp"

#include <algorithm>

namespace visibility::extended_projection {

namespace {

void add_once(std::vector<Point2d>& points, Point2d const& p)
{
  if (std::ranges::find(points, p) == points.end()) points.push_back(p);
}

}  // namespace

CellViews::CellViews(Frame const& f, ViewCell const& cell) : frame(f), is_box(cell.is_box() || f.is_turned())
{
  for (auto const& p : cell.vertices()) bounds.extend(f.around(p));
  near = bounds.max.z;
  if (f.is_turned()) {
    auto const corners = bounds.corners();
    vertices.assign(corners.begin(), corners.end());
  } else {
    for (auto const& p : cell.vertices()) vertices.push_back(f(p));
  }
  for (auto const& c : vertices) {
    add_once(profile_u, {c.x, c.z});
    add_once(profile_v, {c.y, c.z});
  }
}

}  // namespace visibility::extended_projection
