#pragma once

#include "visibility/kernel/point.hpp"

#include <cmath>
#include <cstdint>

namespace visibility::detail {

/// SplitMix64 [Steele, Lea & Flood 2014] with distributions of our own: the same numbers on every machine. Cheap to
/// seed, so every batch of rays has its own.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  Random(std::uint64_t seed, std::uint64_t stream) : state_(seed)
  {
    state_ = bits() ^ (stream * 0xD1342543DE82EF95U);
    state_ = bits();
  }

  std::uint64_t bits()
  {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  ///< [0, 1)
  double uniform(double lo, double hi) { return lo + (hi - lo) * unit(); }
  double log_uniform(double lo, double hi) { return lo * std::pow(hi / lo, unit()); }
  bool chance(double p) { return unit() < p; }
  /// Requires: n > 0.
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(unit() * static_cast<double>(n)); }

  /// Uniform on the unit sphere [Archimedes].
  Point3d direction()
  {
    double const z = uniform(-1, 1), angle = uniform(0, 6.283185307179586), r = std::sqrt(std::fmax(0, 1 - z * z));
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

private:
  std::uint64_t state_;
};

}  // namespace visibility::detail
