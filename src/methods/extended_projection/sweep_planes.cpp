#include "sweep_planes.hpp"

#include "visibility/methods/extended_projection/plane_choice.hpp"

#include <algorithm>
#include <cmath>

namespace visibility::extended_projection {

namespace {

constexpr int default_planes = 15;

/// Of the distances of a plane and the next, unless their number would not reach the end of the scene. The formula of
/// the paper knows no bound, and sends the second plane out of the scene if the cell is small against its distance.
constexpr double widest_ratio = 1.4;

/// The least distance of the far side of an occluder that reaches into its plane's raster; infinite if there is none.
double first_distance(CellViews const& cell, std::span<Box const> important, double extent)
{
  double first = HUGE_VAL;
  for (auto const& b : important) {
    double const d = b.max.z - cell.near;
    Rectangle const r = extended_rectangle(cell, b.max.z, extent);
    if (d > 0 && common(r, {{b.min.x, b.min.y}, {b.max.x, b.max.y}}).area() > 0) first = std::min(first, d);
  }
  return first;
}

}  // namespace

std::vector<double> sweep_planes(CellViews const& cell, Box const& scene, std::span<Box const> important,
                                 Options const& options)
{
  std::vector<double> planes;
  for (double const d : options.distances) planes.push_back(cell.near + d);
  std::ranges::sort(planes);
  if (!planes.empty()) return planes;
  double const last = scene.max.z - cell.near, first = first_distance(cell, important, options.extent);
  if (!(first < last)) return planes;
  double const size = std::max(cell.bounds.max.x - cell.bounds.min.x, cell.bounds.max.y - cell.bounds.min.y);
  int const count = options.planes > 0 ? options.planes : default_planes;
  double d = std::max(first, size);
  double const least_ratio = std::pow(last / d, 1.0 / count);
  while (static_cast<int>(planes.size()) < count && d < last) {
    planes.push_back(cell.near + d);
    double const plane_size = size + 2 * options.extent * d;
    double const step = d * (options.kernel - 1) * plane_size / (size * options.resolution);
    d = std::max(std::min(d + step, widest_ratio * d), d * least_ratio);
  }
  return planes;
}

std::optional<Grid> sweep_grid(CellViews const& cell, Box const& scene, double plane, Options const& options)
{
  Rectangle r = extended_rectangle(cell, plane, options.extent);
  if (cell.frame.has_vertical_v()) {
    double const low = std::min(scene.min.y, cell.bounds.min.y), high = std::max(scene.max.y, cell.bounds.max.y);
    double const margin = 0.03 * (high - low);
    r = common(r, {{-HUGE_VAL, low - margin}, {HUGE_VAL, high + margin}});
  }
  return raster_over(r, options.resolution);
}

}  // namespace visibility::extended_projection
