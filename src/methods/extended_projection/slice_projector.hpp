#pragma once

#include "shell_slice.hpp"

#include "visibility/methods/extended_projection/occluder_projector.hpp"
#include "visibility/methods/extended_projection/projection_map.hpp"
#include "visibility/scene/prepared_scene.hpp"

#include <cstdint>
#include <optional>

namespace visibility::extended_projection {

/// Adds sections of closed meshes, of any shape, with the plane of a map [Durand00, 3.3]: whatever lies behind one is
/// hidden, for the sight line has entered the mesh (proofs/extended_projection.md, "Slices").
class SliceProjector {
public:
  /// Keeps references.
  SliceProjector(PreparedScene const& scene, ViewCell const& cell, OccluderProjector const& occluders);

  /// Whether a shell of the object may have a section with the plane: a choice.
  bool crosses(std::uint32_t object, ProjectionMap const& map) const;
  /// Adds the sections of the object's shells where they seem to tell more than the map does; returns the number of
  /// pixels.
  std::int64_t add(std::uint32_t object, ProjectionMap& map);

  std::size_t count() const { return count_; }  ///< of slices added

private:
  bool encloses_from_outside(EnclosingShell const& shell) const;

  PreparedScene const& scene_;
  ViewCell const& cell_;
  std::optional<Ground> ground_;
  std::size_t count_ = 0;
};

}  // namespace visibility::extended_projection
