#include "visibility/methods/extended_projection/occluder_projector.hpp"

#include "scene/plan.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient2d.hpp"

#include "visibility/geometry/shape_vertices.hpp"

#include <algorithm>
#include <type_traits>

namespace visibility::extended_projection {

namespace {

/// Parts nearer to the cell than this share of the plane's distance are cut off; their views reach far out.
constexpr double nearest_share = 0x1p-10;

/// How far upright solids are carried down, in heights of scene and cell.
constexpr double depth_below = 64;

/// In tilted frames the way down leads away from the cell, or towards it: by so many of these heights at most.
constexpr double most_depth_away = 1;

/// And where down is as steep as this, solids are not carried.
constexpr double steepest = 0.75;

/// Points inside the ball: of its cube and its octahedron, a little smaller, so that rounding leaves them inside.
void append_inner_points(Ball const& b, std::vector<Point3d>& out)
{
  double const size = std::max({std::fabs(b.centre.x), std::fabs(b.centre.y), std::fabs(b.centre.z)}), r = b.radius;
  if (!(size * 0x1p-50 <= r * 1e-4) || r < 0x1p-500) return;
  double const h = 0.577 * r, a = 0.999 * r;
  append_vertices(
    Box{{b.centre.x - h, b.centre.y - h, b.centre.z - h}, {b.centre.x + h, b.centre.y + h, b.centre.z + h}}, out);
  for (auto const axis : {&Point3d::x, &Point3d::y, &Point3d::z})
    for (double const way : {-a, a}) {
      Point3d p = b.centre;
      p.*axis += way;
      out.push_back(p);
    }
}

}  // namespace

OccluderProjector::OccluderProjector(PreparedScene const& scene, ViewCell const& cell, PartDepth depth)
  : scene_(&scene), cell_(&cell), depth_(depth)
{
  Box const& all = scene.object_hierarchy().nodes()[0].bounds;
  ground_ = cell.bounds().min.z >= scene.ground() ? scene.ground() : all.min.z;
  is_above_ground_ = cell.bounds().min.z >= ground_;
  height_ = std::max(all.max.z, cell.bounds().max.z) - ground_;
}

void OccluderProjector::collect(std::uint32_t i, Frame const& frame)
{
  vertices_.clear();
  scene_->occluders().visit(i, [&](auto const& shape) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(shape)>, Ball>)
      append_inner_points(shape, vertices_);
    else
      append_vertices(shape, vertices_);
  });
  double const rise = std::fabs(frame.rise());
  if (rise < steepest && is_above_ground_ && scene_->occluders().bounds()[i].min.z <= ground_)
    carry_down(deep_along(rise));
}

/// `rise` of the frame: the way down may not lead far along w.
double OccluderProjector::deep_along(double rise) const
{
  return ground_ - height_ * (rise > 0 ? std::min(depth_below, most_depth_away / rise) : depth_below);
}

/// If every vertex lies above the hull's lowest side, the hull is what lies between its upper side and the height of
/// that.
void OccluderProjector::carry_down(double deep)
{
  constexpr std::size_t most = 64;
  if (vertices_.size() > most) return;
  double const foot = std::ranges::min(vertices_, {}, &Point3d::z).z;
  if (foot <= deep) return;
  detail::plan::Polygon feet;
  for (auto const& p : vertices_)
    if (p.z == foot) feet.push_back(horizontal(p));
  auto const has_foot = [&](Point3d const& p) { return p.z == foot || std::ranges::count(feet, horizontal(p)) > 0; };
  if (!std::ranges::all_of(vertices_, has_foot)) {
    auto const side = detail::plan::convex_hull(feet);
    auto const is_above = [&](Point3d const& p) {
      for (std::size_t i = 0; i < side.size(); ++i)
        if (is_negative(orient2d<Filtered>(side[i], side[(i + 1) % side.size()], horizontal(p)))) return false;
      return true;
    };
    if (side.size() < 3 || !std::ranges::all_of(vertices_, is_above)) return;
  }
  for (auto& p : vertices_)
    if (p.z == foot) p.z = deep;
}

std::int64_t OccluderProjector::add(std::uint32_t i, ProjectionMap& map, double until)
{
  CellViews const& cell = map.cell();
  double const start = cell.near + (nearest_ > 0 ? nearest_ : (map.plane() - cell.near) * nearest_share);
  if (!(start > cell.near) || cell.frame(scene_->occluders().bounds()[i]).max.z <= start) return 0;
  collect(i, cell.frame);
  if (vertices_.size() < 3) return 0;
  part_.clear();
  double most_off = 0;
  for (auto const& p : vertices_) {
    double const off = cell.frame.error(p);
    part_.push_back({cell.frame(p), off, cell.frame.depth_error(p)});
    most_off = std::max(most_off, part_.back().depth_error);
  }
  double const least = nearest(part_), greatest = deepest(part_);
  if (greatest <= start) return 0;

  std::int64_t pixels = 0;
  auto const add_cut = [&](double low, double high) {
    if (least >= low && greatest <= high)
      pixels += map.add(part_, depth_);
    else if (low < high)
      pixels += map.add(cut(part_, low, high), depth_);
  };
  // The vertices of the cell suffice on either side of the plane, not for a body across it.
  add_cut(start, std::min(until, map.plane()));
  if (greatest > map.plane() && until > map.plane()) add_cut(map.plane(), until);
  // A side next to the cell hides what is behind it, even within the depth of the body.
  if (least >= start && least < greatest && least <= until) {
    std::erase_if(part_, [&](PartPoint const& p) { return p.at.z > least + 8 * most_off; });
    if (part_.size() > 2) pixels += map.add(part_, depth_);
  }
  return pixels;
}

}  // namespace visibility::extended_projection
