#pragma once

#include "visibility/scene/height_field.hpp"
#include "visibility/scene/occludees.hpp"
#include "visibility/scene/seams.hpp"

#include <array>
#include <optional>
#include <vector>

namespace visibility {

/// A straight part of a piece next to which the piece is exposed: nothing covers it there. If a sight line that crosses
/// it in plan stays above all columns up to it, it can be moved so that it ends in the piece beside it.
struct ExposedLine {
  SeamPart part;   ///< as seen along sight lines that cross it in the direction asked for
  Point3d inside;  ///< the corner of the piece towards which it is exposed
  /// A segment with double ends that contains the part in plan, left and right end as above; none: sight lines that
  /// cross the part leave the piece by one of its sides.
  std::optional<std::array<Point3d, 2>> gate;
};

/// The exposed parts of the sides of a piece: looked for just behind a side by which sight lines enter the piece and
/// just before one by which they leave it; of a wall, its upper boundary, from both sides.
std::vector<ExposedLine> exposed_sides(HeightField const& occluders, Occludees const& occludees, std::uint32_t piece);

/// The exposed parts of the lines where columns rise above a piece that is no wall: it is seen just before them. Some
/// of the parts may lie where the piece is exposed on both sides. Cost: rationals for every column that rises above the
/// piece somewhere in it.
std::vector<ExposedLine> exposed_seams(HeightField const& occluders, Occludees const& occludees, std::uint32_t piece);

/// Whether sight lines from right above or below see part of the piece inside the convex polygon, which is
/// counterclockwise in plan: exposed with area, or, a wall, with length. `sides`: its exposed_sides().
bool is_exposed_inside(HeightField const& occluders, Occludees const& occludees, std::uint32_t piece,
                       std::span<ExposedLine const> sides, std::span<Point3d const> polygon);

}  // namespace visibility
