#pragma once

#include <cstdint>

namespace visibility::exact_25d {

/// What a query did.
struct Counts {
  std::uint64_t nodes_tested = 0;        ///< groups of edges held against the occlusion tree
  std::uint64_t nodes_hidden = 0;        ///< of these, found hidden with all they hold
  std::uint64_t portal_tests = 0;        ///< an edge in a leaf of the tree ("portal tests" of [Bittner05, table 3])
  std::uint64_t wedge_hidden = 0;        ///< decided by a penumbra wedge: hidden
  std::uint64_t sampled_visible = 0;     ///< decided by a sampled sight line: visible
  std::uint64_t decisions = 0;           ///< portal decisions: neither sufficed
  std::uint64_t decided_visible = 0;     ///< of these, with a sight line
  std::uint64_t shots = 0;               ///< sight lines held against the whole scene
  std::uint64_t shots_blocked = 0;       ///< of these, stopped by an edge that the tree did not hold there
  std::uint64_t occluders_inserted = 0;  ///< edges in leaves of the tree
};

}  // namespace visibility::exact_25d
