#pragma once

#include "visibility/scene/height_field.hpp"

#include <cstdint>
#include <span>

namespace visibility {

/// Whether sight lines from right above see part of the object inside the convex polygon, which is counterclockwise in
/// plan: part of a top with area, or of a wall or a curtain with length. Where tops of two objects coincide both are
/// seen. False if the object lies outside. Exact for all finite input. Requires: a polygon with area, object <
/// objects.size(). Cost: signs for each edge and column of the object; where they meet the polygon, rationals.  Source:
/// proofs/exact_2_5d.md, "Columns within the outline".
bool is_exposed_inside(HeightField const& field, std::uint32_t object, std::span<Point3d const> polygon);

}  // namespace visibility
