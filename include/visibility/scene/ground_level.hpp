#pragma once

#include "visibility/geometry/box.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace visibility {

/// The height on which objects with these bounds stand: that of the lowest, unless it is one of a few strays below a
/// level on which half of all stand: then that level. What reaches below has to be treated apart. 0 without bounds.
inline double ground_level(std::span<Box const> bounds)
{
  constexpr std::size_t strays_per_object = 200;  // at most one in so many
  std::vector<double> feet;
  feet.reserve(bounds.size());
  for (auto const& b : bounds) feet.push_back(b.min.z);
  if (feet.empty()) return 0;
  double const lowest = std::ranges::min(feet);
  auto const middle = feet.begin() + static_cast<std::ptrdiff_t>(feet.size() / 2);
  std::ranges::nth_element(feet, middle);
  double const level = *middle;
  auto const strays = static_cast<std::size_t>(std::ranges::count_if(feet, [&](double z) { return z < level; }));
  return strays * strays_per_object <= feet.size() ? level : lowest;
}

}  // namespace visibility
