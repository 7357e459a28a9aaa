#include "visibility/methods/extended_projection/plane_choice.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace visibility::extended_projection {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nearest_ratio = 1.2;  // of the distances of two planes
constexpr std::size_t most_candidates = 48, most_rated = 256;

/// The common part of the views of [low, high] x [w0, w1] from a profile.
std::pair<double, double> common_interval(std::vector<Point2d> const& profile, double low, double high, double w0,
                                          double w1, double plane)
{
  double least = -inf, greatest = inf;
  for (auto const& c : profile) {
    double const r0 = (plane - c.y) / (w0 - c.y), r1 = (plane - c.y) / (w1 - c.y);
    least = std::max(least, c.x + std::min((low - c.x) * r0, (low - c.x) * r1));
    greatest = std::min(greatest, c.x + std::max((high - c.x) * r0, (high - c.x) * r1));
  }
  return {least, greatest};
}

}  // namespace

std::optional<Grid> raster_over(Rectangle const& r, int resolution)
{
  constexpr double much = 4;
  double const width = r.high.x - r.low.x, height = r.high.y - r.low.y;
  int columns = resolution, rows = resolution;
  if (resolution > 1 && 2 * resolution <= Grid::max_size && (width > much * height || height > much * width)) {
    columns = 2 * resolution;
    rows = resolution / 2;
    if (height > width) std::swap(columns, rows);
  }
  try {
    return Grid::covering(r.low, r.high, columns, rows);
  } catch (std::invalid_argument const&) {
    return {};
  }
}

Rectangle common_view(CellViews const& cell, Box const& box, double plane)
{
  // Of a box across the plane, the part before it.
  double const w0 = std::max(box.min.z, cell.near + (plane - cell.near) / 1024),
               w1 = w0 < plane ? std::min(box.max.z, plane) : box.max.z;
  if (!(w0 <= w1)) return {{0, 0}, {0, 0}};
  auto const u = common_interval(cell.profile_u, box.min.x, box.max.x, w0, w1, plane);
  auto const v = common_interval(cell.profile_v, box.min.y, box.max.y, w0, w1, plane);
  return {{u.first, v.first}, {u.second, v.second}};
}

Rectangle extended_rectangle(CellViews const& cell, double plane, double extent)
{
  double const reach = extent * (plane - cell.near);
  return {{cell.bounds.min.x - reach, cell.bounds.min.y - reach},
          {cell.bounds.max.x + reach, cell.bounds.max.y + reach}};
}

std::vector<double> choose_planes(CellViews const& cell, std::span<Box const> occluders, Options const& options,
                                  int count)
{
  struct Candidate {
    double plane, filled;
  };
  std::vector<Candidate> candidates;
  auto const rated = occluders.first(std::min(occluders.size(), most_rated));
  for (auto const& o : occluders.first(std::min(occluders.size(), most_candidates))) {
    double const plane = o.max.z;
    if (!(plane > cell.near)) continue;
    Rectangle const all = extended_rectangle(cell, plane, options.extent);
    double filled = 0;
    for (auto const& b : rated) filled += common(common_view(cell, b, plane), all).area();
    candidates.push_back({plane, filled / all.area()});
  }
  std::ranges::stable_sort(candidates, std::ranges::greater{}, &Candidate::filled);
  std::vector<double> planes;
  for (auto const& c : candidates) {
    if (static_cast<int>(planes.size()) == count || !(c.filled > 0)) break;
    double const d = c.plane - cell.near;
    bool const is_new = std::ranges::none_of(
      planes, [&](double p) { return d < nearest_ratio * (p - cell.near) && p - cell.near < nearest_ratio * d; });
    if (is_new) planes.push_back(c.plane);
  }
  std::ranges::sort(planes);
  return planes;
}

std::optional<Grid> choose_grid(CellViews const& cell, std::span<Box const> occluders, double plane, double lowest_v,
                                Options const& options)
{
  Rectangle all = extended_rectangle(cell, plane, options.extent);
  all.low.y = std::max(all.low.y, lowest_v);
  Rectangle filled{{inf, inf}, {-inf, -inf}};
  for (auto const& o : occluders) {
    Rectangle const r = common(common_view(cell, o, plane), all);
    if (!(r.area() > 0)) continue;
    filled = {{std::min(filled.low.x, r.low.x), std::min(filled.low.y, r.low.y)},
              {std::max(filled.high.x, r.high.x), std::max(filled.high.y, r.high.y)}};
  }
  if (!(filled.area() > 0)) return {};
  // What stands on the ground is projected down to below it.
  if (lowest_v > -inf) filled.low.y = all.low.y;
  return raster_over(filled, options.resolution);
}

}  // namespace visibility::extended_projection
