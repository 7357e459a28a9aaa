#pragma once

#include "support/height_field_oracle.hpp"

#include <vector>

/// Polygons in space, in rationals.
namespace visibility::oracle::detail {

using Polygon = std::vector<Point3d>;

bool has_area(Polygon const& polygon);

/// The polygon as targets of a plan: itself, counterclockwise, if it has area in plan, else the upper edges of which it
/// is the fence, each as two points. Requires: convex with area.
std::vector<Polygon> targets(Polygon const& polygon);

}  // namespace visibility::oracle::detail
