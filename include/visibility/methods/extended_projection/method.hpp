#pragma once

#include "visibility/methods/extended_projection/options.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <span>
#include <utility>

namespace visibility {

/// Extended projections: occluders are projected onto a few planes around the cell, as what all points of the cell see
/// of them, into depth maps; an object is hidden if all that any point of the cell sees of it lies behind. Occluders
/// fuse. Conservative, whatever the options: all rounding is to the safe side, and every choice is free.
/// Takes any scene: boxes, prisms, polyhedra, balls and triangles are occluders.
/// Source: [Durand00]; method and departures: docs/extended-projection.md; proof: proofs/extended_projection.md.
class ExtendedProjection {
public:
  using Options = extended_projection::Options;

  ExtendedProjection() = default;
  /// Throws std::invalid_argument for options out of range.
  explicit ExtendedProjection(Options options) : options_(std::move(options)) { options_.validate(); }

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
