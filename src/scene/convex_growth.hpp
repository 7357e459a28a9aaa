#pragma once

#include "plan.hpp"

#include <span>

namespace visibility::detail {

/// A large convex polygon that contains `seed` and avoids the ring edges, up to rounding: what half-planes leave of the
/// rings' bounds. Each half-plane is bounded by the line of a ring edge or of a seed edge, chosen greedily.
/// Requires: a convex counterclockwise seed inside the rings.
plan::Polygon grow(std::span<plan::Polygon const> rings, plan::Polygon const& seed);

/// Whether the convex polygon (counterclockwise, strict turns) lies in the region that the rings enclose an odd number
/// of times, closed. Exact.
bool lies_inside(std::span<plan::Polygon const> rings, plan::Polygon const& convex);

}  // namespace visibility::detail
