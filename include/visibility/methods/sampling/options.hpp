#pragma once

#include <cstdint>

namespace visibility::sampling {

struct Options {
  std::uint64_t rays = 1'000'000;
  double seconds = 0;  ///< wall-clock limit; 0: none. A run that it ends is not reproducible
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all. The result does not depend on it
};

}  // namespace visibility::sampling
