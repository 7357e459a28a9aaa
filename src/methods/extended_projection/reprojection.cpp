#include "reprojection.hpp"

#include "view_range.hpp"

#include <algorithm>

namespace visibility::extended_projection {

namespace {

/// Pixels [first, last] that a pixel is seen through from all of the cell, along one axis; none if it leaves the
/// raster.
struct Window {
  int first = 0, last = -1;
};

/// The windows of the `count` pixels along an axis of the plane `to`, in a raster of `from_count` pixels on `from`.
std::vector<Window> windows(std::vector<Point2d> const& profile, double to, double to_origin, double to_step, int count,
                            double from, double from_origin, double from_step, int from_count)
{
  std::vector<Window> out(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    // Lines of a raster are doubles (Grid), so these are they.
    double const low = to_origin + i * to_step, high = to_origin + (i + 1) * to_step;
    auto const r = view_range(profile, low, high, to, to, from);
    double const a = in_pixels({r.low, r.error}, -1, from_origin, from_step),
                 b = in_pixels({r.high, r.error}, 1, from_origin, from_step);
    if (!(a >= pixel_margin && b <= from_count - pixel_margin)) continue;
    out[static_cast<std::size_t>(i)] = {static_cast<int>(a - pixel_margin), static_cast<int>(b + pixel_margin)};
  }
  return out;
}

/// Maxima over the windows of each row. From running maxima over 2^k pixels, with 2^k at most the size of all windows,
/// two make up a window of less than twice that size.
DepthMap<float> farthest_in_rows(DepthMap<float> const& from, std::vector<Window> const& columns)
{
  int const n = from.width(), width = static_cast<int>(columns.size());
  int least = n;
  for (auto const& w : columns)
    if (w.first <= w.last) least = std::min(least, w.last - w.first + 1);
  int reach = 1;
  while (2 * reach <= least) reach *= 2;
  DepthMap<float> out(width, from.height());
  std::vector<float> running(static_cast<std::size_t>(n));
  for (int y = 0; y < from.height(); ++y) {
    std::copy_n(from.row(y), n, running.data());
    for (int r = 1; r < reach; r *= 2)
      for (int x = 0; x + 2 * r <= n; ++x)
        running[std::size_t(x)] = std::max(running[std::size_t(x)], running[std::size_t(x + r)]);
    float* const to = out.row(y);
    for (int x = 0; x < width; ++x) {
      auto const [first, last] = columns[std::size_t(x)];
      if (first > last) continue;
      float depth = running[std::size_t(last + 1 - reach)];
      for (int k = first; k + reach <= last; k += reach) depth = std::max(depth, running[std::size_t(k)]);
      to[x] = depth;
    }
  }
  return out;
}

/// Maxima over the windows of each column, whole rows at a time.
DepthMap<float> farthest_in_columns(DepthMap<float> const& from, std::vector<Window> const& rows)
{
  int const width = from.width(), height = static_cast<int>(rows.size());
  DepthMap<float> out(width, height);
  for (int y = 0; y < height; ++y) {
    auto const [first, last] = rows[std::size_t(y)];
    if (first > last) continue;
    float* const to = out.row(y);
    std::copy_n(from.row(first), width, to);
    for (int k = first + 1; k <= last; ++k) {
      float const* const depths = from.row(k);
      for (int x = 0; x < width; ++x) to[x] = to[x] < depths[x] ? depths[x] : to[x];
    }
  }
  return out;
}

}  // namespace

DepthMap<float> reproject(ProjectionMap const& from, double plane, Grid const& grid)
{
  Grid const& g = from.grid();
  auto const& cell = from.cell();
  auto const columns = windows(cell.profile_u, plane, grid.origin().x, grid.step().x, grid.width(), from.plane(),
                               g.origin().x, g.step().x, g.width());
  auto const rows = windows(cell.profile_v, plane, grid.origin().y, grid.step().y, grid.height(), from.plane(),
                            g.origin().y, g.step().y, g.height());
  return farthest_in_columns(farthest_in_rows(from.depths(), columns), rows);
}

}  // namespace visibility::extended_projection
