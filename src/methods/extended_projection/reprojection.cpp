#include "reprojection.hpp"

#include "view_range.hpp"

#include "visibility/raster/convolution.hpp"

#include <algorithm>

namespace visibility::extended_projection {

namespace {

/// Pixels [first, last] that a pixel is seen through from all of the cell, along one axis; none if it leaves the
/// raster.
struct Window {
  int first = 0, last = -1;
};

/// Points of a cell in (u, w) or (v, w), the first coordinate of each at most `error` off.
struct Profile {
  std::vector<Point2d> points;
  double error = 0;
};

/// A raster on a plane, along one axis.
struct Axis {
  double plane, origin, step;
  int count;
};

Axis columns_of(Grid const& g, double plane) { return {plane, g.origin().x, g.step().x, g.width()}; }
Axis rows_of(Grid const& g, double plane) { return {plane, g.origin().y, g.step().y, g.height()}; }

/// The windows of the pixels of `to` in `from`, along an axis.
std::vector<Window> windows(Profile const& cell, Axis const& from, Axis const& to)
{
  std::vector<Window> out(static_cast<std::size_t>(to.count));
  for (int i = 0; i < to.count; ++i) {
    // Lines of a raster are doubles (Grid), so these are they.
    double const low = to.origin + i * to.step, high = to.origin + (i + 1) * to.step;
    auto const r = view_range(cell.points, low, high, to.plane, to.plane, from.plane);
    // Between a point of the cell and one of the plane the former's error shrinks.
    double const error = r.error + cell.error;
    double const a = in_pixels({r.low, error}, -1, from.origin, from.step),
                 b = in_pixels({r.high, error}, 1, from.origin, from.step);
    if (!(a >= pixel_margin && b <= from.count - pixel_margin)) continue;
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

/// The flat cell at w = near that all lines from the cell to the raster pass, along an axis.
Profile equivalent_cell(std::vector<Point2d> const& profile, double near, Axis const& to)
{
  double const low = to.origin, high = to.origin + to.count * to.step;
  Range range;
  double error = 0;
  for (auto const& c : profile) {
    if (c.y == near) {
      range.add(c.x);
      continue;
    }
    auto const r = view_range({c}, low, high, to.plane, to.plane, near);
    range.add(r.low);
    range.add(r.high);
    error = std::max(error, r.error);
  }
  return {{{range.low, near}, {range.high, near}}, error};
}

/// The size of the largest window; 0 if all are empty.
int largest(std::vector<Window> const& windows)
{
  int size = 0;
  for (auto const& w : windows) size = std::max(size, w.last - w.first + 1);
  return size;
}

}  // namespace

DepthMap<float> reproject_by_windows(ProjectionMap const& from, double plane, Grid const& grid)
{
  auto const& cell = from.cell();
  auto const columns = windows({cell.profile_u}, columns_of(from.grid(), from.plane()), columns_of(grid, plane));
  auto const rows = windows({cell.profile_v}, rows_of(from.grid(), from.plane()), rows_of(grid, plane));
  return farthest_in_columns(farthest_in_rows(from.depths(), columns), rows);
}

DepthMap<float> reproject_by_convolution(ProjectionMap const& from, double plane, Grid const& grid)
{
  auto const& cell = from.cell();
  Axis const new_columns = columns_of(grid, plane), new_rows = rows_of(grid, plane);
  auto const columns = windows(equivalent_cell(cell.profile_u, cell.near, new_columns),
                               columns_of(from.grid(), from.plane()), new_columns);
  auto const rows =
    windows(equivalent_cell(cell.profile_v, cell.near, new_rows), rows_of(from.grid(), from.plane()), new_rows);
  DepthMap<float> out(grid.width(), grid.height());
  int const width = largest(columns), height = largest(rows);
  if (width == 0 || height == 0) return out;
  auto const eroded = erode(from.depths(), PixelKernel::rectangle({0, 0}, {width - 1.0, height - 1.0}));
  for (int y = 0; y < grid.height(); ++y) {
    auto const& r = rows[std::size_t(y)];
    if (r.first > r.last) continue;
    float const* const depths = eroded.row(r.first);
    float* const to = out.row(y);
    for (int x = 0; x < grid.width(); ++x) {
      auto const& c = columns[std::size_t(x)];
      if (c.first <= c.last) to[x] = depths[c.first];
    }
  }
  return out;
}

}  // namespace visibility::extended_projection
