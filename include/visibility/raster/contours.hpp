#pragma once

#include "visibility/kernel/point.hpp"
#include "visibility/raster/grid.hpp"
#include "visibility/raster/span.hpp"

#include <span>
#include <utility>
#include <vector>

namespace visibility {

/// Closed polygons (the last point joins the first), in any orientation, that bound a region by the even-odd rule:
/// outlines, holes, islands in holes. They may touch, overlap, cross and degenerate.
using Contours = std::vector<std::vector<Point2d>>;

/// The pixels that lie wholly inside the region: no contour passes through the interior of the pixel, and its inner
/// points are inside. Edges that occur twice, in either direction, do not count, so regions that share an edge are one
/// region. `error` as in Outline; the region meant is that of the contours meant. The conservative scan conversion of a
/// slice of a concave occluder [Durand00, section 3.3]. Points out of the domain of PixelRegion: no pixel.
Spans inner_even_odd(Grid const&, Contours const&, Point2d const& error = {0, 0});

/// An edge of contours, in either direction.
using ContourEdge = std::pair<Point2d, Point2d>;

/// The same for contours given as edges in any order: above the line y = `low`, and only pixels above it count, every
/// point must be an end of an even number of edges. Of those that are equal to the last bit, an even number counts as
/// none if `error` is 0.
Spans inner_even_odd(Grid const&, std::span<ContourEdge const>, Point2d const& error, double low);

}  // namespace visibility
