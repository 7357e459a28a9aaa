#pragma once

#include <cstdint>
#include <functional>

namespace visibility::sampling {

struct Options {
  std::uint64_t rays = 1'000'000;
  double seconds = 0;  ///< wall-clock limit; 0: none. A run that it ends is not reproducible
  std::uint64_t seed = 1;
  int threads = 0;                                     ///< 0: all. The result does not depend on it
  std::function<void(std::uint64_t rays)> progress{};  ///< told how many rays have been cast since it was last told
};

}  // namespace visibility::sampling
