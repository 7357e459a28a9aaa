#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/methods/strong_occlusion/counts.hpp"
#include "visibility/methods/strong_occlusion/shaft.hpp"
#include "visibility/scene/occluders.hpp"

namespace visibility::strong_occlusion {

/// Whether the occluder at this position blocks every half-open sight line [c, s) from the cell to the shaft's target.
/// It is enough that it blocks those between vertices (proofs/strong_occlusion.md, Theorem 1), and those along hull
/// edges if it touches neither cell nor target (Theorem 2). The paper tests closed segments; there two coinciding faces
/// would hide each other. Exact. Requires: it blocks_from(cell). Counts candidates and rays.  Source: [CohenOr98, 3].
template <Arithmetic A>
bool blocks_all(Occluders const& occluders, std::uint32_t occluder, Shaft& shaft, Counts& counts)
{
  Box const& bounds = occluders.bounds()[occluder];
  if (!shaft.within_slabs(bounds)) return false;
  ++counts.candidates;
  return occluders.visit(occluder, [&]<class Shape>(Shape const& shape) {
    auto const meets = [&](Ray const& r) {
      // For a box, within_slabs has decided one half of segment_meets for all sight lines.
      if constexpr (std::same_as<Shape, Box>)
        return line_meets<A>(shape, r.from, r.to);
      else
        return !SegmentProbe(r.from, r.to).certainly_misses(bounds) &&
               segment_meets<A, End::excluded>(shape, r.from, r.to);
    };
    if (!shaft.all_rays(counts.rays, meets)) return false;
    if (shaft.decides(bounds)) return true;
    for (auto const& s : shaft.target().vertices)
      for (auto const& c : shaft.cell().vertices()) {
        ++counts.rays;
        if (!meets({c, s})) return false;
      }
    return true;
  });
}

}  // namespace visibility::strong_occlusion
