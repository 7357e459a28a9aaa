#pragma once

#include "visibility/kernel/point.hpp"
#include "visibility/raster/fixed_points.hpp"
#include "visibility/raster/grid.hpp"
#include "visibility/raster/half_plane.hpp"
#include "visibility/raster/span.hpp"

#include <span>
#include <vector>

namespace visibility {

/// The convex hull of points, each known to within a rounding: the point meant lies in [x - error.x, x + error.x] x
/// [y - error.y, y + error.y]. Any number of points in any order, repeated or on one line. Requires: error >= 0.
struct Outline {
  std::span<Point2d const> points;
  Point2d error{0, 0};
};

/// Pixels of a rectangle that satisfy linear inequalities; in each row an interval. Conservative scan conversion of
/// convex polygons, and of intersections of them, in integers: [Durand00, section 3.2] without shrinking, stencil and
/// hardware. Exact for points that are on the grid of 2^-36 pixels (less for polygons larger than 2^11 pixels);
/// otherwise off by at most 2^-36 pixels, to the safe side (proofs/raster.md). Points more than 2^46 pixels off, or not
/// finite, are out of the domain: no pixel is inside, and every one touched unless the bounds of the points exclude it.
class PixelRegion {
public:
  /// All pixels of the grid.
  explicit PixelRegion(Grid const& grid) : grid_(grid) { reset(); }
  void reset();

  /// Drops the pixels that do not lie wholly inside the outline (Cover::inside), or do not meet it.
  void keep(Outline const&, Cover);
  void keep(HalfPlane const&, Cover);
  void keep(PixelHalfPlane const&);
  void keep(PixelRectangle const&);

  /// Writes what is left to `spans` (whose capacity is reused).
  void spans(Spans& spans);

  Grid const& grid() const { return grid_; }
  PixelRectangle const& bounds() const { return bounds_; }  ///< encloses what is left

private:
  PixelRectangle pixel_bounds(Cover) const;

  Grid grid_;
  PixelRectangle bounds_;
  std::vector<PixelHalfPlane> half_planes_;
  detail::FixedPoints fixed_;      // scratch
  std::vector<int> left_, right_;  // scratch: interval of each row
};

/// The pixels that lie wholly inside all outlines: the Projection of a convex occluder is the intersection of its views
/// from the vertices of the cell [Durand00, section 3.2].
Spans inner(Grid const&, std::span<Outline const>);
/// The pixels that the closed outline meets; a segment and a point have some too.
Spans outer(Grid const&, Outline const&);

}  // namespace visibility
