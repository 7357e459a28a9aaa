#pragma once

#include <cmath>
#include <limits>

namespace visibility::ray_space {

/// The nearest float that is at most x, or at least x.
inline float float_below(double x)
{
  auto const f = static_cast<float>(x);
  return static_cast<double>(f) <= x ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
inline float float_above(double x)
{
  auto const f = static_cast<float>(x);
  return static_cast<double>(f) >= x ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
}

/// x after up to 2^5 roundings of relative error 2^-53, to the safe side.
inline double safely_below(double x) { return x - std::fabs(x) * 0x1p-47; }
inline double safely_above(double x) { return x + std::fabs(x) * 0x1p-47; }

}  // namespace visibility::ray_space
