#pragma once

#include <cstdlib>
#include <string>

namespace visibility::test {

/// Number of random trials: `base`, times the environment variable VISIBILITY_TRIALS_SCALE (default 1). The one place
/// that decides how long random tests run; at scale 50 every predicate is asked at least a million times.
inline int trials(int base)
{
  char const* const text = std::getenv("VISIBILITY_TRIALS_SCALE");
  double const scale = text == nullptr ? 1.0 : std::strtod(text, nullptr);
  return scale > 0 ? static_cast<int>(base * scale) : base;
}

}  // namespace visibility::test
