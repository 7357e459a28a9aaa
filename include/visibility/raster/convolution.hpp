#pragma once

#include "visibility/raster/depth_map.hpp"
#include "visibility/raster/pixel_region.hpp"

namespace visibility {

/// Offsets of pixels that a kernel K, a convex set in units of pixels, reaches from a pixel: all o such that some point
/// of the pixel moved by some point of K comes into the interior of the pixel o away. One interval [begin, end) per row
/// of offsets, `rows[k].row` being a row offset; ordered by row, none missing in between.
struct PixelKernel {
  Spans rows;

  /// K = [low.x, high.x] x [low.y, high.y]. Requires: low <= high, finite. A point at an integer offset is a plain
  /// shift. Throws std::invalid_argument if K reaches farther than Grid::max_size pixels.
  static PixelKernel rectangle(Point2d const& low, Point2d const& high);
  /// K = the outline, in units of pixels; `error` enlarges it. Throws like rectangle, and if there are no points.
  static PixelKernel polygon(Outline const&);

  /// Whether all rows have the same interval.
  bool is_rectangle() const;
};

/// The erosion of a map by a kernel: pixel p of the result is covered iff all pixels p + o, o in the kernel, are
/// covered (and in the map), and stores the farthest of their depths. So p swept by K lies behind what the map holds:
/// the convolution of [Durand00, section 5.1], binary and with depth. Cost per pixel: a rectangle of w x h pixels takes
/// log2 w + 3 maxima ([VanHerk92, GilWerman93] along columns, doubling along rows, which vectorises); another kernel of
/// h rows log2 w + 2 h maxima.
template <class T>
DepthMap<T> erode(DepthMap<T> const&, PixelKernel const&);

extern template DepthMap<float> erode(DepthMap<float> const&, PixelKernel const&);
extern template DepthMap<double> erode(DepthMap<double> const&, PixelKernel const&);

}  // namespace visibility
