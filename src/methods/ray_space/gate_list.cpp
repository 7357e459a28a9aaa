#include "visibility/methods/ray_space/gate_list.hpp"

#include <algorithm>

namespace visibility::ray_space {

namespace {

/// How much of the view a gate blocks, for the choice of what to keep.
float size(Gate const& g)
{
  constexpr float steepest = 4;
  return std::clamp(g.top.slope, -steepest, steepest) - std::clamp(g.bottom.slope, -steepest, steepest);
}

bool is_smaller(Gate const& a, Gate const& b) { return size(a) < size(b); }

}  // namespace

bool GateList::add(Gate gate, int most)
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
  auto* const begin = gates_.data();
  size_ =
    static_cast<int>(std::remove_if(begin, begin + size_, [&](Gate const& g) { return dominates(gate, g); }) - begin);
  if (size_ < most) {
    begin[size_++] = gate;
  } else {
    auto* const least = std::min_element(begin, begin + size_, is_smaller);
    if (size(*least) > size(gate)) return false;
    *least = gate;
  }
  std::swap(*begin, *std::max_element(begin, begin + size_, is_smaller));
  return true;
}

}  // namespace visibility::ray_space
