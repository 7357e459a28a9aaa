#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace visibility::ray_space {

/// The next float in the direction of -infinity, or +infinity. Requires: f is not that infinity, and no NaN.
inline float next_below(float f)
{
  if (f == 0) return -std::numeric_limits<float>::denorm_min();
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(f) + (f > 0 ? -1 : 1));
}
inline float next_above(float f) { return -next_below(-f); }

/// The nearest float that is at most x, or at least x.
inline float float_below(double x)
{
  auto const f = static_cast<float>(x);
  return static_cast<double>(f) > x ? next_below(f) : f;
}
inline float float_above(double x)
{
  auto const f = static_cast<float>(x);
  return static_cast<double>(f) < x ? next_above(f) : f;
}

/// x after up to 2^5 roundings of relative error 2^-53, to the safe side.
inline double safely_below(double x) { return x - std::fabs(x) * 0x1p-47; }
inline double safely_above(double x) { return x + std::fabs(x) * 0x1p-47; }

}  // namespace visibility::ray_space
