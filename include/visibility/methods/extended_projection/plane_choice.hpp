#pragma once

#include "visibility/methods/extended_projection/cell_views.hpp"
#include "visibility/methods/extended_projection/options.hpp"
#include "visibility/raster/grid.hpp"

#include <optional>
#include <span>
#include <vector>

namespace visibility::extended_projection {

/// A rectangle of a plane.
struct Rectangle {
  Point2d low, high;
  double area() const { return low.x < high.x && low.y < high.y ? (high.x - low.x) * (high.y - low.y) : 0; }
};
inline Rectangle common(Rectangle const& a, Rectangle const& b)
{
  return {{std::fmax(a.low.x, b.low.x), std::fmax(a.low.y, b.low.y)},
          {std::fmin(a.high.x, b.high.x), std::fmin(a.high.y, b.high.y)}};
}

/// A raster of resolution x resolution pixels over the rectangle; of twice as many columns and half as many rows, or
/// the other way round, if it is much wider than high, or higher than wide. Empty if the rectangle has no area or is
/// too narrow for its coordinates.
std::optional<Grid> raster_over(Rectangle const& rectangle, int resolution);

/// What all views of a box have in common, about: rounded, and with bounding rectangles for views. For choices only.
Rectangle common_view(CellViews const& cell, Box const& box, double plane);

/// The part of a plane that a map is for: up to extent * distance beyond the sides of the cell.
Rectangle extended_rectangle(CellViews const& cell, double plane, double extent);

/// Where `count` planes should stand: just behind occluders, the one with most pixels filled first [Durand00, 6.1],
/// none too near to one before. `occluders` in the frame, most important first.
/// Fewer if there are no occluders. Ascending. All of this is a choice.
std::vector<double> choose_planes(CellViews const& cell, std::span<Box const> occluders, Options const& options,
                                  int count);

/// The raster of a plane: the extended rectangle, less what no occluder can fill. `lowest_v`: what is below need not be
/// covered. Empty if nothing can be filled, or the rectangle is too narrow for its coordinates.
std::optional<Grid> choose_grid(CellViews const& cell, std::span<Box const> occluders, double plane, double lowest_v,
                                Options const& options);

}  // namespace visibility::extended_projection
