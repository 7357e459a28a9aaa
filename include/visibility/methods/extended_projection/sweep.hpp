#pragma once

#include "visibility/methods/extended_projection/options.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <span>
#include <utility>

namespace visibility {

/// Occlusion sweep: planes leave the cell in each of six directions; each takes over what the one before knows and adds
/// the occluders in between, so that many small ones, such as leaves, come to hide what is behind. What is hidden is
/// neither tested nor projected again. Conservative, whatever the options.
/// Takes any scene. Source: [Durand00, 5]; docs/occlusion-sweep.md; proof: proofs/extended_projection.md.
class OcclusionSweep {
public:
  using Options = extended_projection::Options;

  OcclusionSweep() = default;
  /// Throws std::invalid_argument for options out of range.
  explicit OcclusionSweep(Options options) : options_(std::move(options)) { options_.validate(); }

  /// The potentially visible set: `conservative`. Statistics: planes, occluders (projected), slices, pixels (written),
  /// boxes_tested, groups_hidden.
  PotentiallyVisibleSet operator()(PreparedScene const& scene, ViewCell const& cell) const;
  /// Those of the candidates that may be visible, ascending; candidates alone occlude. Where the others are hidden from
  /// a cell around this one, the set is conservative (proofs/preprocess.md, "Candidates"). Requires: ascending objects.
  PotentiallyVisibleSet operator()(PreparedScene const& scene, ViewCell const& cell,
                                   std::span<std::uint32_t const> candidates) const;

private:
  Options options_;
};

}  // namespace visibility
