#pragma once

#include "visibility/kernel/point.hpp"
#include "visibility/raster/grid.hpp"
#include "visibility/raster/span.hpp"

namespace visibility {

/// A depth (or its inverse, or a slope: any quantity) that is affine over the plane: at + (dx, dy) it is
/// value + slope.x dx + slope.y dy, and what is meant differs from that by at most `error` on the raster.
struct AffineDepth {
  Point2d at{0, 0};
  double value = 0;
  Point2d slope{0, 0};
  double error = 0;
};

/// A bound of an affine depth over each closed pixel, from one side.
class PixelDepth {
public:
  /// At least the depth everywhere in the pixel: for occluders.
  static PixelDepth above(Grid const&, AffineDepth const&);
  /// At most the depth everywhere in the pixel: for occludees.
  static PixelDepth below(Grid const&, AffineDepth const&);

  /// The bound at pixel (i, j), safe as computed, fused or not; also after rounding to float by DepthMap. Infinite (and
  /// so uncovered, or nearest) if the depth reaches 2^126 in the raster.
  double operator()(int i, int j) const { return row(j) + slope_.x * i; }

  double row(int j) const { return base_ + slope_.y * j; }  ///< the part of row j
  double slope() const { return slope_.x; }                 ///< from pixel to pixel
  double magnitude() const { return magnitude_; }           ///< bounds what is added up in any pixel of the raster
  bool is_constant() const { return slope_.x == 0 && slope_.y == 0; }
  /// The same bound, farther by `margin`.
  PixelDepth farther(double margin) const;

private:
  double base_ = 0, magnitude_ = 0;
  Point2d slope_{0, 0};
};

/// The least value of a bound from below over a set of pixels; +infinity if it is empty.
double nearest(PixelDepth const& below, Spans const&);

}  // namespace visibility
