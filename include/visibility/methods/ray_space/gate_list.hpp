#pragma once

#include "visibility/methods/ray_space/vertical_slice.hpp"

#include <span>

namespace visibility::ray_space {

/// The gates of one pixel, the largest first, in memory that somebody else keeps.
class GateList {
public:
  /// `size` of the gates are there already; there is room for `most`.
  GateList(Gate* gates, int size, int most) : gates_(gates), size_(size), most_(most) {}

  std::span<Gate const> gates() const { return {gates_, static_cast<std::size_t>(size_)}; }
  int size() const { return size_; }

  /// Takes a gate that was in a list before, after those it was with. Requires: there is room.
  void keep(Gate const& gate) { gates_[size_++] = gate; }

  /// Fuses the gate with those that are there where no gap is left, and drops what it then dominates; of too many gates
  /// the smallest goes. Returns whether none of those that were there dominates it. [Leyvand03, section 3.2]
  bool add(Gate gate);

private:
  Gate* gates_;
  int size_, most_;
};

}  // namespace visibility::ray_space
