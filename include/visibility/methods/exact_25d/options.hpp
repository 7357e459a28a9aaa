#pragma once

namespace visibility::exact_25d {

/// What the answer does not depend on, unless it says so.
struct Options {
  bool hierarchical_culling = true;  ///< drop groups of edges that the occlusion tree hides
  bool penumbra_wedges = true;       ///< decide by shadow planes where they suffice
  bool sampled_lines = true;         ///< try a few sight lines before the portal decision
  bool witnesses = false;            ///< a rational sight line for every visible object that does not meet the cell
};

}  // namespace visibility::exact_25d
