#pragma once

#include "visibility/methods/extended_projection/projection_map.hpp"

namespace visibility::extended_projection {

/// What a map knows, on another plane and raster: for each pixel the farthest depth of the pixels on from.plane() that
/// lines from all of the cell to all of the pixel pass; empty where one of them is, or lies out of the raster. The
/// windows of a pixel are found for its own column and row, so no equivalent cell is needed, and no rasters that fit
/// each other. Requires: near < from.plane() < plane.  Source: [Durand00, 5.1].
DepthMap<float> reproject_by_windows(ProjectionMap const& from, double plane, Grid const& grid);

/// The same by convolution: windows of one size for all pixels, from an equivalent cell, the flat rectangle w = near
/// that all lines from the cell to the new raster pass. It may be empty, or farther, where reproject_by_windows is not;
/// the cost of a pixel does not grow with its window. Source: [Durand00, 5.1].
DepthMap<float> reproject_by_convolution(ProjectionMap const& from, double plane, Grid const& grid);

}  // namespace visibility::extended_projection
