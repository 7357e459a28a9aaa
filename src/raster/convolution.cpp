#include "visibility/raster/convolution.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace visibility {

namespace {

int checked(double offset)
{
  if (!(std::fabs(offset) <= Grid::max_size)) throw std::invalid_argument("PixelKernel: reaches too far");
  return static_cast<int>(offset);
}

template <class T>
T farther(T a, T b)
{
  return a < b ? b : a;
}

/// Row y of the map at columns [first, first + n), +infinity out of the map.
template <class T>
void padded_row(DepthMap<T> const& map, int y, int first, std::vector<T>& out)
{
  std::fill(out.begin(), out.end(), DepthMap<T>::empty);
  if (y < 0 || y >= map.height()) return;
  int const n = static_cast<int>(out.size()), begin = std::max(first, 0), end = std::min(first + n, map.width());
  if (begin < end) std::copy(map.row(y) + begin, map.row(y) + end, out.begin() + (begin - first));
}

/// to[i] = the farther of from[i] and from[i + shift]; to may be from.
template <class T>
void merge_shifted(T const* from, T* to, int n, int shift)
{
  for (int i = 0; i < n; ++i) to[i] = farther(from[i], from[i + shift]);
}

template <class T>
void merge(T const* from, T* to, int n)
{
  for (int i = 0; i < n; ++i) to[i] = farther(from[i], to[i]);
}

/// Running maximum along rows: result (x, y) is that of map (x + begin ... x + end - 1, y).
template <class T>
DepthMap<T> erode_rows(DepthMap<T> const& map, int begin, int end)
{
  int const width = map.width(), window = end - begin, n = width + window - 1;
  DepthMap<T> result(width, map.height());
  std::vector<T> line(static_cast<std::size_t>(n));
  for (int y = 0; y < map.height(); ++y) {
    padded_row(map, y, begin, line);
    int reach = 1;  // line[i] covers [i, i + reach)
    for (; 2 * reach <= window; reach *= 2) merge_shifted(line.data(), line.data(), n - 2 * reach + 1, reach);
    merge_shifted(line.data(), result.row(y), width, window - reach);
  }
  return result;
}

/// Running maximum along columns by [VanHerk92, GilWerman93], whole rows at a time: in blocks of as many rows as the
/// window is high, maxima to the end of a block and from the start of the next.
template <class T>
DepthMap<T> erode_columns(DepthMap<T> const& map, int begin, int end)
{
  int const width = map.width(), height = map.height(), window = end - begin;
  if (window == 1 && begin == 0) return map;
  DepthMap<T> result(width, height);
  auto const row_size = static_cast<std::size_t>(width);
  std::vector<T> to_end(row_size * static_cast<std::size_t>(window)), from_start(row_size), next(row_size);
  auto const suffix = [&](int k) { return to_end.data() + row_size * static_cast<std::size_t>(k); };
  for (int block = 0; block < height; block += window) {
    for (int k = window - 1; k >= 0; --k) {
      padded_row(map, block + k + begin, 0, next);
      std::copy(next.begin(), next.end(), suffix(k));
      if (k + 1 < window) merge(suffix(k + 1), suffix(k), width);
    }
    std::copy(suffix(0), suffix(0) + row_size, result.row(block));
    for (int k = 1; k < std::min(window, height - block); ++k) {
      padded_row(map, block + window + k - 1 + begin, 0, next);
      if (k == 1)
        from_start = next;
      else
        merge(next.data(), from_start.data(), width);
      std::copy(suffix(k), suffix(k) + row_size, result.row(block + k));
      merge(from_start.data(), result.row(block + k), width);
    }
  }
  return result;
}

/// Row by row of the map: maxima over windows of 1, 2, 4, ... columns, from which two windows make any interval of the
/// kernel; each of its rows contributes to one row of the result.
template <class T>
DepthMap<T> erode_by_rows(DepthMap<T> const& map, Spans const& rows)
{
  int const width = map.width(), height = map.height();
  int first = rows.front().begin, last = rows.front().end - 1, widest = 1;
  for (auto const& r : rows) {
    first = std::min(first, r.begin);
    last = std::max(last, r.end - 1);
    widest = std::max(widest, r.end - r.begin);
  }
  int const n = width + last - first;
  std::vector<std::vector<T>> windows;
  for (int reach = 1; reach <= widest; reach *= 2) windows.emplace_back(static_cast<std::size_t>(n));

  DepthMap<T> result(width, height);
  // Rows whose kernel leaves the map stay empty; the others start from the first row of the kernel.
  int const begin = std::max(0, -rows.front().row), end = std::min(height, height - rows.back().row);
  for (int y = std::max(0, begin + rows.front().row); y < std::min(height, end + rows.back().row); ++y) {
    padded_row(map, y, first, windows[0]);
    for (std::size_t k = 1; k < windows.size(); ++k) {
      int const reach = 1 << (k - 1);
      merge_shifted(windows[k - 1].data(), windows[k].data(), n - 2 * reach + 1, reach);
    }
    for (auto const& r : rows) {
      int const target = y - r.row, size = r.end - r.begin;
      if (target < begin || target >= end) continue;
      std::size_t k = 0;
      while (2 << k <= size) ++k;
      T const *const a = windows[k].data() + (r.begin - first), *const b = a + (size - (1 << k));
      T* const out = result.row(target);
      if (r.row == rows.front().row)  // the first one that reaches this target
        for (int x = 0; x < width; ++x) out[x] = farther(a[x], b[x]);
      else
        for (int x = 0; x < width; ++x) out[x] = farther(out[x], farther(a[x], b[x]));
    }
  }
  return result;
}

}  // namespace

PixelKernel PixelKernel::rectangle(Point2d const& low, Point2d const& high)
{
  // An open pair of pixels (o - 1, o + 1) meets [low, high] iff floor(low) <= o <= ceil(high).
  int const x0 = checked(std::floor(low.x)), x1 = checked(std::ceil(high.x)) + 1;
  int const y0 = checked(std::floor(low.y)), y1 = checked(std::ceil(high.y)) + 1;
  PixelKernel kernel;
  for (int y = y0; y < y1; ++y) kernel.rows.push_back({y, x0, x1});
  return kernel;
}

PixelKernel PixelKernel::polygon(Outline const& outline)
{
  detail::FixedPoints fixed;
  if (outline.points.empty()) throw std::invalid_argument("PixelKernel: no points");
  if (!fixed.assign(outline.points, {0, 0}, {1, 1}, outline.error))
    throw std::invalid_argument("PixelKernel: reaches too far");
  fixed.reduce_to_hull();
  auto const box = fixed.outer_bounds();
  int const f = fixed.fraction;
  PixelRectangle const bounds{checked(static_cast<double>(detail::floor_units(box.u0, f))),
                              checked(static_cast<double>(detail::floor_units(box.v0, f))),
                              checked(static_cast<double>(detail::ceil_units(box.u1, f))) + 1,
                              checked(static_cast<double>(detail::ceil_units(box.v1, f))) + 1};
  auto const count = static_cast<std::size_t>(bounds.y1 - bounds.y0);
  std::vector<int> left(count, bounds.x0), right(count, bounds.x1);
  auto const& hull = fixed.points;
  for (std::size_t i = 0, n = hull.size(); n > 1 && i < n; ++i) {
    auto const &p = hull[i], &q = hull[i + 1 == n ? 0 : i + 1];
    if (p.u == q.u || p.v == q.v) continue;  // decided by the bounds
    detail::clip_rows(left_of(p, q, fixed, detail::EdgeCover::pair_interior_touching), bounds, left.data(),
                      right.data());
  }
  PixelKernel kernel;
  for (std::size_t k = 0; k < count; ++k) kernel.rows.push_back({bounds.y0 + static_cast<int>(k), left[k], right[k]});
  return kernel;
}

bool PixelKernel::is_rectangle() const
{
  return std::all_of(rows.begin(), rows.end(),
                     [&](Span const& r) { return r.begin == rows.front().begin && r.end == rows.front().end; });
}

template <class T>
DepthMap<T> erode(DepthMap<T> const& map, PixelKernel const& kernel)
{
  if (kernel.rows.empty()) throw std::invalid_argument("erode: an empty kernel");
  auto const &first = kernel.rows.front(), &last = kernel.rows.back();
  if (kernel.is_rectangle()) return erode_columns(erode_rows(map, first.begin, first.end), first.row, last.row + 1);
  return erode_by_rows(map, kernel.rows);
}

template DepthMap<float> erode(DepthMap<float> const&, PixelKernel const&);
template DepthMap<double> erode(DepthMap<double> const&, PixelKernel const&);

}  // namespace visibility
