#pragma once

#include "visibility/scene/footprint.hpp"

#include <vector>

namespace visibility {

/// Convex prisms inside a prism that overlap each other, each grown from a piece of its convex partition until every
/// side is held by a wall: an L gives its two bars. Their corners may be rounded points; that each lies inside the
/// prism is decided exactly (proofs/inner_bodies.md). They need not cover the prism: use them next to
/// `convex_partition`. Largest first, at most `most`; empty if the partition is, or if it is a single piece.
std::vector<ConvexPrism> convex_cover(Prism const& prism, std::size_t most = 16);

}  // namespace visibility
