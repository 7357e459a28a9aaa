#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/scene/convex_bodies.hpp"

#include <cstdint>
#include <span>

namespace visibility::strong_occlusion {

/// Whether the body blocks every half-open sight line [c, s) from a vertex c of the cell to a vertex s of the target.
/// Then it blocks every sight line from the cell's convex hull to the target's: for fixed s the points c whose segment
/// [c, s) meets a convex set form a convex set, and so do, for fixed c, the points s (proofs/strong_occlusion.md).
/// The test uses closed segments in the paper; there two coinciding faces would hide each other.
/// Requires: no vertex is in both lists. `rays` counts the segments tested.  Source: [Cohen-Or98, 3].
template <Arithmetic A>
bool blocks_all(ConvexBodies const& scene, ConvexBodies::Body const& body, std::span<Point3d const> cell,
                std::span<Point3d const> target, std::uint64_t& rays)
{
  for (auto const& s : target)
    for (auto const& c : cell) {
      ++rays;
      if (!segment_meets<A, End::excluded>(scene, body, c, s)) return false;
    }
  return true;
}

}  // namespace visibility::strong_occlusion
