#pragma once

#include "visibility/methods/ray_space/counts.hpp"
#include "visibility/methods/ray_space/options.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <utility>
#include <vector>

namespace visibility {

/// Ray-space factorization: sight lines by their horizontal direction, in pixels of a bounded ray space; in each pixel
/// the heights that occluders block, fused. Conservative, whatever the resolution and the number of umbrae.
/// Takes any scene. From a cell that is no box it answers for the smallest box around the cell.
/// Source: [Leyvand03]; method and departures: docs/ray-space.md; proof: proofs/ray_space.md.
class RaySpace {
public:
  using Options = ray_space::Options;

  RaySpace() = default;
  /// Throws std::invalid_argument for options out of range.
  explicit RaySpace(Options options) : options_(options) { options_.validate(); }

  /// The potentially visible set: `conservative`. Statistics: ray_space::Counts.
  PotentiallyVisibleSet operator()(PreparedScene const& scene, ViewCell const& cell) const;

  /// The set, and the potentially visible triangles (positions in Scene::triangles, ascending): of the visible objects
  /// those that are not hidden one by one. [Leyvand03, section 4.1, the option]
  std::pair<PotentiallyVisibleSet, std::vector<std::uint32_t>> triangles(PreparedScene const& scene,
                                                                         ViewCell const& cell) const;

private:
  Options options_;
};

}  // namespace visibility
