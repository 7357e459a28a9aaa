#pragma once

#include "visibility/methods/extended_projection/cell_views.hpp"

#include <optional>
#include <span>
#include <vector>

namespace visibility::extended_projection {

/// The hull of some points, all of it at w > near of the cell, on one side of the projection plane: what "the views
/// from the vertices of the cell suffice" holds for (proofs/extended_projection.md, "Vertices suffice"; for an occluder
/// that crosses the plane it is false).
using ConvexPart = std::vector<PartPoint>;

/// The hull of the points cut to low <= w <= high. Points that arise are rounded and carry their error. A hull of many
/// points may come out smaller, never larger. Empty if there is nothing.
ConvexPart cut(std::span<PartPoint const> points, double low, double high);

/// The point where the segment pq meets w = `at`, rounded, with its error. None if its place on the segment is too
/// small a number, or not known. Requires: `at` between their w.
std::optional<PartPoint> crossing(PartPoint const& p, PartPoint const& q, double at);

/// A bound of the greatest w of a part, and of the least. Requires: points.
double deepest(std::span<PartPoint const> part);
double nearest(std::span<PartPoint const> part);

}  // namespace visibility::extended_projection
