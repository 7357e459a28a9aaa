#pragma once

#include "visibility/methods/sampling/options.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

namespace visibility {

class RayScene;

/// Guided sampling: rays propose sight lines, an exact predicate confirms each. A lower bound: every object listed has
/// a witness or meets the closed cell; visible objects may be missing.
/// Takes any scene. Sources: [Wonka06] for mutation and reverse sampling; docs/sampling.md.
class Sampling {
public:
  using Options = sampling::Options;

  Sampling() = default;
  explicit Sampling(Options options) : options_(options) {}

  /// The visible objects found: `aggressive`, with witnesses. Statistics: rays, hits, seen (objects hit by a ray),
  /// touching (objects that meet the cell), rejected (candidates that the exact predicate refused), and per strategy
  /// rays_* and finds_*.
  PotentiallyVisibleSet operator()(PreparedScene const& scene, ViewCell const& cell) const;
  /// The same with rays built once for many cells.
  PotentiallyVisibleSet operator()(RayScene const& rays, ViewCell const& cell) const;

private:
  Options options_;
};

}  // namespace visibility
