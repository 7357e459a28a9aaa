#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/methods/strong_occlusion/counts.hpp"
#include "visibility/methods/strong_occlusion/shaft.hpp"
#include "visibility/scene/convex_bodies.hpp"

namespace visibility::strong_occlusion {

/// Whether the body blocks every half-open sight line [c, s) from the cell to the shaft's target. It is enough that it
/// blocks those between vertices (proofs/strong_occlusion.md, Theorem 1), and those along hull edges if it touches
/// neither cell nor target (Theorem 2). The paper tests closed segments; there two coinciding faces would hide each
/// other. Exact. Counts candidates and rays.  Source: [CohenOr98, 3].
template <Arithmetic A>
bool blocks_all(ConvexBodies const& scene, ConvexBodies::Body const& body, Box const& bounds, Shaft& shaft,
                Counts& counts)
{
  if (!shaft.within_slabs(bounds)) return false;
  ++counts.candidates;
  bool const is_box = body.kind == ConvexBodies::Kind::box;
  auto const meets = [&](Ray const& r) {
    // For a box, within_slabs has decided one half of segment_meets for all sight lines.
    if (is_box) return line_meets<A>(scene.box(body), r.from, r.to);
    return !SegmentProbe(r.from, r.to).certainly_misses(bounds) &&
           segment_meets<A, End::excluded>(scene, body, r.from, r.to);
  };
  if (!shaft.all_rays(counts.rays, meets)) return false;
  if (shaft.decides(bounds)) return true;
  for (auto const& s : shaft.target().vertices)
    for (auto const& c : shaft.cell().vertices()) {
      ++counts.rays;
      if (!meets({c, s})) return false;
    }
  return true;
}

}  // namespace visibility::strong_occlusion
