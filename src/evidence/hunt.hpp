#pragma once

#include "strategies.hpp"
#include "visibility/evidence/witness.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace visibility::detail {

struct HuntLimits {
  std::uint64_t rays;
  double seconds;  ///< 0: no limit
  std::uint64_t seed;
  int threads;                                    ///< 0: all
  std::function<void(std::uint64_t)> progress{};  ///< told after each round how many rays it cast
};

struct HuntReport {
  std::vector<std::uint32_t> found;  ///< objects found visible, ascending; never one that was known
  std::vector<Witness> witnesses;    ///< of those that do not meet the closed cell, by ascending object
  std::vector<std::uint32_t> seen;   ///< objects that a ray hit, known or not, ascending
  std::uint64_t rays = 0, hits = 0;
  std::uint64_t rejected = 0;  ///< candidates that the exact predicate refused
  std::array<std::uint64_t, strategies> cast{}, finds{};
  double seconds = 0;
};

/// Hunts for visible objects besides the known ones: rays propose, the exact predicate confirms. Rounds of rays are
/// planned on what the rounds before have found, so that for a given seed the report is the same for any number of
/// threads, unless the time limit ends it.
HuntReport hunt(RayScene const& rays, ViewCell const& cell, std::span<std::uint32_t const> known,
                HuntLimits const& limits);

}  // namespace visibility::detail
