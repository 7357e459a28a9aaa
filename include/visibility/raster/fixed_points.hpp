#pragma once

#include "visibility/kernel/point.hpp"
#include "visibility/raster/half_plane.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace visibility::detail {

/// Coordinates in units of 2^-fraction of a pixel, |u|, |v| <= 2^47; off_u, off_v are 1 if they were rounded.
struct FixedPoint {
  std::int64_t u, v;
  std::int8_t off_u = 0, off_v = 0;
  friend auto operator<=>(FixedPoint const&, FixedPoint const&) = default;
};

/// A coordinate in pixels, rounded, and whether it is exact.
struct PixelCoordinate {
  double value;
  bool is_exact;
};

/// [u0, u1] x [v0, v1] in the same units.
struct PixelBox {
  std::int64_t u0, v0, u1, v1;
};

/// Points of the plane in units of a raster's pixels, on a grid fine enough for 47 bits. A point meant is at most
/// error_u + off_u, error_v + off_v units off: not at all if it is on that grid and the caller's error is 0
/// (proofs/raster.md).
struct FixedPoints {
  static constexpr int coordinate_bits = 47, max_fraction = 36;

  std::vector<FixedPoint> points;
  std::vector<FixedPoint> all;  ///< the points before reduce_to_hull(), if some are rounded and some are not
  std::vector<std::pair<PixelCoordinate, PixelCoordinate>> pixels;  ///< scratch
  int fraction = 0;
  std::int64_t error_u = 0, error_v = 0;

  /// Replaces what is here by the points. `false` if they are out of the domain: not finite, or 2^46 pixels off.
  bool assign(std::span<Point2d const>, Point2d const& origin, Point2d const& step, Point2d const& error);
  /// Leaves the vertices of the convex hull, counterclockwise, no three on a line. Exact. One point or two if they are
  /// all equal or on a line.
  void reduce_to_hull();

  /// Bounds of the points, enlarged by their errors, or reduced. Requires: points.
  PixelBox outer_bounds() const;
  PixelBox inner_bounds() const;
};

/// Which pixels an edge line leaves. As Cover, and `interior_touching`: a pixel counts if its interior reaches the open
/// side; `pair_interior_touching`: so does that of the 2 x 2 pixels around its lower corner.
enum class EdgeCover { inside, touching, interior_touching, pair_interior_touching };

/// The pixels on the left of the line from p to q, closer by the error for `inside`, farther for the others: by the
/// error of p and q for `interior_touching`, otherwise by so much that it holds all points. Requires: p, q consecutive
/// vertices of the hull, unless `interior_touching`.
PixelHalfPlane left_of(FixedPoint const& p, FixedPoint const& q, FixedPoints const&, EdgeCover);

/// floor(x / 2^bits) and ceil(x / 2^bits).
constexpr std::int64_t floor_units(std::int64_t x, int bits) { return x >> bits; }
constexpr std::int64_t ceil_units(std::int64_t x, int bits) { return -(-x >> bits); }

/// Clips, in each row y of [y0, y1), the interval [left[y - y0], right[y - y0]) to the pixels of the half-plane; both
/// limits stay in [x0, x1] (and left may pass right). Requires: a != 0; x, y within +-Grid::max_size.
void clip_rows(PixelHalfPlane const&, PixelRectangle const& bounds, int* left, int* right);

}  // namespace visibility::detail
