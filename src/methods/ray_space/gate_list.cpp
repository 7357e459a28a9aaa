#include "visibility/methods/ray_space/gate_list.hpp"

#include <algorithm>

namespace visibility::ray_space {

namespace {

/// How much of the view a gate blocks, for the choice of what to keep.
float extent(Gate const& g)
{
  constexpr float steepest = 4;
  return std::clamp(g.top.slope, -steepest, steepest) - std::clamp(g.bottom.slope, -steepest, steepest);
}

bool is_smaller(Gate const& a, Gate const& b) { return extent(a) < extent(b); }

}  // namespace

bool GateList::add(Gate gate)
{
  for (auto const& g : gates())
    if (dominates(g, gate)) return false;
  // Fusing may make it reach another, which it did not reach before.
  for (int pass = 0; pass < size_; ++pass) {
    bool changed = false;
    for (auto const& g : gates())
      if (auto const both = fused(g, gate)) gate = *both, changed = true;
    if (!changed) break;
  }
  size_ = static_cast<int>(std::remove_if(gates_, gates_ + size_, [&](Gate const& g) { return dominates(gate, g); }) -
                           gates_);
  if (size_ < most_) {
    gates_[size_++] = gate;
  } else {
    auto* const least = std::min_element(gates_, gates_ + size_, is_smaller);
    if (extent(*least) > extent(gate)) return true;
    *least = gate;
  }
  std::swap(*gates_, *std::max_element(gates_, gates_ + size_, is_smaller));
  return true;
}

}  // namespace visibility::ray_space
