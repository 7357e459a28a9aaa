#pragma once

#include "visibility/kernel/point.hpp"

namespace visibility {

/// A raster over a rectangle of the plane: width x height pixels, pixel (i, j) the closed rectangle between column
/// lines i and i + 1 and row lines j and j + 1. Every column and row line is exactly a double (origin and step are
/// integers over a common power of two), so a pixel means the same to every caller. Proof: proofs/raster.md.
class Grid {
public:
  static constexpr int max_size = 4096;                               ///< of width and of height
  static constexpr double min_step = 0x1p-900, max_extent = 0x1p900;  ///< domain of pixel sizes and of coordinates

  /// The grid whose lines of index 0 and (width, height) enclose [low, high] as tightly as such doubles do: they lie
  /// beyond it by less than 2^-37 of its largest coordinate, and not at all where the pixel size is a short double.
  /// Throws std::invalid_argument unless 1 <= width, height <= max_size, and low < high are finite, in the domain and
  /// at least 2^-36 of their magnitude apart.
  static Grid covering(Point2d const& low, Point2d const& high, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  Point2d const& origin() const { return origin_; }  ///< lower corner of pixel (0, 0)
  Point2d const& step() const { return step_; }      ///< size of a pixel

  /// Column line i and row line j, exact for 0 <= i <= width, 0 <= j <= height. Requires: in that range.
  double column_line(int i) const { return origin_.x + i * step_.x; }
  double row_line(int j) const { return origin_.y + j * step_.y; }

  friend bool operator==(Grid const&, Grid const&) = default;

private:
  Grid(Point2d const& origin, Point2d const& step, int width, int height)
    : origin_(origin), step_(step), width_(width), height_(height)
  {
  }

  Point2d origin_, step_;
  int width_, height_;
};

}  // namespace visibility
