#pragma once

#include "visibility/methods/ray_space/options.hpp"
#include "visibility/methods/ray_space/vertical_slice.hpp"

#include <array>
#include <span>

namespace visibility::ray_space {

/// The gates of one pixel: up to Options::max_components, the largest first.
class GateList {
public:
  std::span<Gate const> gates() const { return {gates_.data(), static_cast<std::size_t>(size_)}; }

  /// Takes a gate that was in a list before, after those it was with. Requires: there is room.
  void keep(Gate const& gate) { gates_[static_cast<std::size_t>(size_++)] = gate; }

  /// Fuses the gate with those that are there where no gap is left, and drops what it then dominates; of more than
  /// `most` gates the smallest goes. Returns whether anything has changed. [Leyvand03, section 3.2]
  bool add(Gate gate, int most);

private:
  std::array<Gate, Options::max_components> gates_;
  int size_ = 0;
};

/// Whether the gate reaches at least as high and as low as these slopes of supporting lines (-infinity: an open bottom)
/// and holds from as near on: a gate within can add nothing to it.
inline bool reaches(Gate const& g, double top, double bottom, double from)
{
  return g.top.slope >= top && g.beyond <= from && (reaches_ground(g) || g.bottom.slope <= bottom);
}

}  // namespace visibility::ray_space
