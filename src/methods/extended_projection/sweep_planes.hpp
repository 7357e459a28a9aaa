#pragma once

#include "visibility/methods/extended_projection/cell_views.hpp"
#include "visibility/methods/extended_projection/options.hpp"
#include "visibility/raster/grid.hpp"

#include <optional>
#include <span>
#include <vector>

namespace visibility::extended_projection {

/// Where the planes of a sweep stand, ascending: from just behind the first important occluder on, so far apart that
/// the image of the cell is as many pixels as the kernel, by the formula of [Durand00, 5.2], but at most by a factor
/// of 1.4; farther if their number would not reach the end of the scene. `scene` and `important` occluders in the
/// frame. None if no occluder lies in the direction. A choice.
std::vector<double> sweep_planes(CellViews const& cell, Box const& scene, std::span<Box const> important,
                                 Options const& options);

/// The part of a plane that sight lines to what is behind it pass, within the heights of scene and cell. Empty if it is
/// too narrow for its coordinates. A choice.
std::optional<Grid> sweep_grid(CellViews const& cell, Box const& scene, double plane, Options const& options);

}  // namespace visibility::extended_projection
