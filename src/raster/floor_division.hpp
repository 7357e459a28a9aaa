#pragma once

#include <cstdint>

namespace visibility::detail {

struct FloorDivision {
  std::int64_t quotient, remainder;  // numerator = quotient * divisor + remainder, 0 <= remainder < divisor
};

/// Requires: divisor > 0.
inline FloorDivision floor_division(std::int64_t numerator, std::int64_t divisor)
{
  std::int64_t quotient = numerator / divisor, remainder = numerator - quotient * divisor;
  if (remainder < 0) {
    --quotient;
    remainder += divisor;
  }
  return {quotient, remainder};
}

}  // namespace visibility::detail
