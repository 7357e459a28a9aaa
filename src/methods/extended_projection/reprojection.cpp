#include "reprojection.hpp"

#include "view_range.hpp"
#include "windows.hpp"

#include "visibility/raster/convolution.hpp"

#include <algorithm>

namespace visibility::extended_projection {

namespace {

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

/// The pixels of `from` that each pixel of `to` is seen through from all of the cell, along an axis; none if it leaves
/// the raster.
std::vector<Window> windows(Profile const& cell, Axis const& from, Axis const& to)
{
  std::vector<double> ratios;
  for (auto const& c : cell.points) ratios.push_back((from.plane - c.y) / (to.plane - c.y));
  std::vector<Window> out(static_cast<std::size_t>(to.count));
  if (!std::ranges::all_of(ratios, in_domain)) return out;
  // The view of a pixel is between those of its lines, from each point.
  auto const view_of_line = [&](int i) {
    // Lines of a raster are doubles (Grid), so this is one.
    double const line = to.origin + i * to.step;
    Range range;
    double size = 0;
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      double const eye = cell.points[k].x, way = (line - eye) * ratios[k];
      range.add(eye + way);
      size = std::max({size, std::fabs(way), std::fabs(eye)});
    }
    return ViewRange{range.low, range.high, view_error(size)};
  };
  auto before = view_of_line(0);
  for (int i = 0; i < to.count; ++i) {
    auto const next = view_of_line(i + 1);
    // Between a point of the cell and one of the plane the former's error shrinks.
    double const a = in_pixels({before.low, before.error + cell.error}, -1, from.origin, from.step),
                 b = in_pixels({next.high, next.error + cell.error}, 1, from.origin, from.step);
    if (a >= pixel_margin && b <= from.count - pixel_margin)
      out[static_cast<std::size_t>(i)] = {static_cast<int>(a - pixel_margin), static_cast<int>(b + pixel_margin)};
    before = next;
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
  for (auto const& w : windows) size = std::max(size, w.size());
  return size;
}

}  // namespace

DepthMap<float> reproject_by_windows(ProjectionMap const& from, double plane, Grid const& grid)
{
  auto const& cell = from.cell();
  auto const columns = windows({cell.profile_u}, columns_of(from.grid(), from.plane()), columns_of(grid, plane));
  auto const rows = windows({cell.profile_v}, rows_of(from.grid(), from.plane()), rows_of(grid, plane));
  return farthest_in_windows(from.depths(), columns, rows);
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
    if (r.is_empty()) continue;
    float const* const depths = eroded.row(r.first);
    float* const to = out.row(y);
    for (int x = 0; x < grid.width(); ++x) {
      auto const& c = columns[std::size_t(x)];
      if (!c.is_empty()) to[x] = depths[c.first];
    }
  }
  return out;
}

}  // namespace visibility::extended_projection
