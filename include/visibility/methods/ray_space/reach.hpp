#pragma once

#include "visibility/methods/ray_space/vertical_slice.hpp"

#include <algorithm>
#include <limits>

namespace visibility::ray_space {

/// How far gates reach: slopes of supporting lines, the greatest of tops and the least of bottoms (-infinity: an open
/// bottom), and the least distance that one holds from. As it comes: no gates. Rounded: for choices of what to look at.
struct Reach {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double top = -infinity, bottom = infinity, from = infinity;

  void extend(Reach const& r)
  {
    top = std::max(top, r.top), bottom = std::min(bottom, r.bottom), from = std::min(from, r.from);
  }
};

/// Whether the gate reaches at least as high and as low and holds from as near on: what reaches no further can add
/// nothing to it.
inline bool reaches(Gate const& g, Reach const& r)
{
  return g.top.slope >= r.top && g.beyond <= r.from && (reaches_ground(g) || g.bottom.slope <= r.bottom);
}

}  // namespace visibility::ray_space
