#pragma once

#include "visibility/methods/extended_projection/cell_views.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace visibility::extended_projection {

/// Of a pixel: covers the roundings of in_pixels.
inline constexpr double pixel_margin = 0x1p-10;

struct Range {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void add(double x)
  {
    low = x < low ? x : low;
    high = x > high ? x : high;
  }
};

/// The range of views of an interval of a coordinate from the points of a profile, and a bound of all errors. The view
/// is monotone in the point and in the eye, so ends suffice (proofs/extended_projection.md, "Occludees").
struct ViewRange {
  double low = HUGE_VAL, high = -HUGE_VAL, error = 0;
};

/// Covers the roundings of views, with `size` the largest term (proofs/extended_projection.md, "Occludees").
inline double view_error(double size) { return 10 * 0x1p-53 * size + 0x1p-1000; }

inline ViewRange view_range(std::vector<Point2d> const& profile, double low, double high, double w0, double w1,
                            double plane)
{
  Range range;
  double size = 0;
  for (auto const& c : profile)
    for (double const w : {w0, w1}) {
      double const ratio = (plane - c.y) / (w - c.y);
      if (!in_domain(ratio)) return {-HUGE_VAL, HUGE_VAL, 0};
      double const a = (low - c.x) * ratio, b = (high - c.x) * ratio;
      range.add(c.x + a);
      range.add(c.x + b);
      size = std::max({size, std::fabs(a), std::fabs(b), std::fabs(c.x)});
    }
  return {range.low, range.high, view_error(size)};
}

/// Of both coordinates of a box.
struct BoxViewRange {
  ViewRange u, v;
};

/// The same for both coordinates of a cell that is a box: its profiles are rectangles of the same two w, so four ratios
/// do for all lines, and low ends come from low ends. Bit for bit what view_range() gives.
inline BoxViewRange box_view_range(Box const& cell, Box const& box, double plane)
{
  constexpr ViewRange unknown{-HUGE_VAL, HUGE_VAL, 0};
  Range u, v;
  double size_u = std::max(std::fabs(cell.min.x), std::fabs(cell.max.x)),
         size_v = std::max(std::fabs(cell.min.y), std::fabs(cell.max.y));
  auto const look = [](double c, double low, double high, double ratio, Range& range, double& size) {
    double const a = (low - c) * ratio, b = (high - c) * ratio;
    range.low = std::min(range.low, c + a);
    range.high = std::max(range.high, c + b);
    size = std::max({size, std::fabs(a), std::fabs(b)});
  };
  for (double const c : {cell.min.z, cell.max.z})
    for (double const w : {box.min.z, box.max.z}) {
      double const ratio = (plane - c) / (w - c);
      if (!in_domain(ratio)) return {unknown, unknown};
      look(cell.min.x, box.min.x, box.max.x, ratio, u, size_u);
      look(cell.max.x, box.min.x, box.max.x, ratio, u, size_u);
      look(cell.min.y, box.min.y, box.max.y, ratio, v, size_v);
      look(cell.max.y, box.min.y, box.max.y, ratio, v, size_v);
    }
  return {{u.low, u.high, view_error(size_u)}, {v.low, v.high, view_error(size_v)}};
}

/// A coordinate in pixels, moved by the bound of its error times `side`; in the raster its own rounding is below 2^-39.
inline double in_pixels(Bounded const& x, double side, double origin, double step)
{
  double const error = x.error * (1 + 0x1p-40) + 4 * 0x1p-53 * std::fabs(x.value);
  return (x.value + side * error - origin) / step;
}

}  // namespace visibility::extended_projection
