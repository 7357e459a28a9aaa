#pragma once

#include "visibility/methods/extended_projection/projection_map.hpp"

namespace visibility::extended_projection {

/// What a map knows, on another plane and raster: for each pixel the farthest depth of the pixels on from.plane() that
/// lines from all of the cell to all of the pixel pass; empty where one of them is, or lies out of the raster. The
/// windows of a pixel are found for its own column and row, so no equivalent cell is needed, and no rasters that fit
/// each other. Requires: near < from.plane() < plane.  Source: [Durand00, 5.1].
DepthMap<float> reproject(ProjectionMap const& from, double plane, Grid const& grid);

}  // namespace visibility::extended_projection
