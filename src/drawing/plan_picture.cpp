#include "visibility/drawing/plan_picture.hpp"

#include "scene/plan.hpp"
#include "visibility/scene/meets_cell.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <cmath>

namespace visibility {

namespace {

constexpr double margin = 0.04;       ///< of the longer side of what is shown
constexpr double most_oblong = 2.5;   ///< longer side of a region over the shorter one
constexpr double largest = 0x1p+900;  ///< metres; beyond, scales and areas overflow
constexpr double smallest = 0x1p-900;

void extend(PlanRegion& r, Box const& b)
{
  r.min = {std::min(r.min.x, b.min.x), std::min(r.min.y, b.min.y)};
  r.max = {std::max(r.max.x, b.max.x), std::max(r.max.y, b.max.y)};
}

/// Lengthens the interval on both sides to the given length, if it is shorter.
void widen(double& low, double& high, double length)
{
  double const missing = length - (high - low);
  if (missing > 0) low -= missing / 2, high += missing / 2;
}

bool reaches_into(Box const& b, PlanRegion const& r)
{
  return b.min.x <= r.max.x && r.min.x <= b.max.x && b.min.y <= r.max.y && r.min.y <= b.max.y;
}

}  // namespace

std::vector<PlanRole> plan_roles_of(PreparedScene const& scene, ViewCell const& cell,
                                    std::span<std::uint32_t const> visible)
{
  return plan_roles_of(scene, cell, visible, visible);
}

std::vector<PlanRole> plan_roles_of(PreparedScene const& scene, ViewCell const& cell,
                                    std::span<std::uint32_t const> first, std::span<std::uint32_t const> second)
{
  std::vector<PlanRole> roles(scene.scene().objects.size(), PlanRole::hidden);
  for (auto const i : first) roles[i] = PlanRole::only_first;
  for (auto const i : second) {
    if (roles[i] == PlanRole::hidden)
      roles[i] = PlanRole::only_second;
    else
      roles[i] = meets_cell(scene, cell, i) ? PlanRole::touching : PlanRole::visible;
  }
  return roles;
}

PlanRegion default_region(Scene const& scene, std::span<PlanRole const> roles, ViewCell const& cell)
{
  PlanRegion r{horizontal(cell.bounds().min), horizontal(cell.bounds().max)};
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (roles[i] != PlanRole::hidden && roles[i] != PlanRole::occluder)
      extend(r, bounding_box(scene, scene.objects[i]));
  double const by = margin * std::max(r.max.x - r.min.x, r.max.y - r.min.y);
  return {{r.min.x - by, r.min.y - by}, {r.max.x + by, r.max.y + by}};
}

PlanPicture plan_picture(ViewCell const& cell, PlanRegion const& region)
{
  PlanPicture out;
  out.region = region;
  auto& [min, max] = out.region;
  double const width = max.x - min.x, height = max.y - min.y;
  if (!(width > 0 && height > 0))
    throw BadInput("the region to draw has no area: its first corner must be the lower left one");
  widen(min.x, max.x, height / most_oblong);
  widen(min.y, max.y, width / most_oblong);
  if (!(std::max(width, height) < largest && std::max(width, height) > smallest && is_finite(min) && is_finite(max)))
    throw BadInput("the region to draw is too large or too small for floating point; scale the scene");
  std::vector<Point2d> corners;
  for (auto const& v : cell.vertices()) corners.push_back(horizontal(v));
  out.cell = detail::plan::convex_hull(std::move(corners));
  return out;
}

void add_objects(PlanPicture& picture, Scene const& scene, std::span<PlanRole const> roles)
{
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    auto const& object = scene.objects[i];
    ++picture.objects_of[static_cast<std::size_t>(roles[i])];
    if (reaches_into(bounding_box(scene, object), picture.region))
      picture.objects.push_back({object.name, roles[i], plan_outline(scene, object)});
  }
}

}  // namespace visibility
