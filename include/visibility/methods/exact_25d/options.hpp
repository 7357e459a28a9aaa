#pragma once

namespace visibility::exact_25d {

/// What hides an edge.
enum class Occlusion {
  exact,         ///< all edges together
  single_wedges  ///< one edge at a time, by its penumbra wedge: a typical conservative method [Bittner05, §6.2]. How
                 ///< loose it is depends on the divisions of line space and on the arithmetic
};

/// The answer depends on `occlusion` and `occluder_shrink` only.
struct Options {
  Occlusion occlusion = Occlusion::exact;
  /// Times the distance from the middle of the cell, the length by which every occluder is shortened at both ends:
  /// simulates a method that samples line space with this spacing [Bittner05, §6.3, table 4]. The guarantee is then
  /// `none`.
  double occluder_shrink = 0;
  bool hierarchical_culling = true;  ///< drop groups of edges that the occlusion tree hides
  bool penumbra_wedges = true;       ///< decide by shadow planes where they suffice
  bool sampled_lines = true;         ///< try a few sight lines before the portal decision
  /// If not null, the seconds of processor time that portal decisions take are added: lines that they find and hold
  /// against the scene included [Bittner05, table 3]. For one query at a time.
  double* decision_seconds = nullptr;
  bool witnesses = false;  ///< a rational sight line for every visible object that does not meet the cell
};

}  // namespace visibility::exact_25d
