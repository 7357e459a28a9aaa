#include "visibility/methods/extended_projection/cell_views.hpp"

#include <algorithm>

namespace visibility::extended_projection {

namespace {

void add_once(std::vector<Point2d>& points, Point2d const& p)
{
  if (std::ranges::find(points, p) == points.end()) points.push_back(p);
}

}  // namespace

CellViews::CellViews(Frame const& f, ViewCell const& cell)
  : frame(f), bounds(f(cell.bounds())), near(bounds.max.z), is_box(cell.is_box())
{
  for (auto const& p : cell.vertices()) {
    Point3d const& c = vertices.emplace_back(f(p));
    add_once(profile_u, {c.x, c.z});
    add_once(profile_v, {c.y, c.z});
  }
}

}  // namespace visibility::extended_projection
