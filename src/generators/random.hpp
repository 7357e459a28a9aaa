#pragma once

#include <algorithm>
#include <cfloat>
#include <cstdint>
#include <string_view>

namespace visibility::generators {

static_assert(FLT_EVAL_METHOD == 0, "generated scenes need doubles that are rounded after every operation");

/// A stream of random numbers, the same on every machine: splitmix64 [Steele, Lea & Flood 2014], which is integer
/// arithmetic only, and distributions made of + - * / and comparisons.
///
/// There is one stream per (seed, purpose, object), so that a new parameter or one more draw for one object leaves
/// everything else as it was. That means millions of streams: hence a state of 8 bytes rather than the 2,500 bytes of
/// std::mt19937_64, and rather than the distributions of <random>, which differ between standard libraries.
class Random {
public:
  Random(std::uint64_t seed, std::string_view purpose, std::uint64_t object = 0)
    : state_(mix(mix(seed ^ hash(purpose)) + object))
  {
  }

  std::uint64_t bits() { return mix(state_ += golden); }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  ///< [0, 1), a multiple of 2^-53
  bool chance(double p) { return unit() < p; }
  /// In [lo, hi]. Requires: lo <= hi. The clamp is for the last rounding only.
  double uniform(double lo, double hi) { return std::min(hi, lo + (hi - lo) * unit()); }
  double around(double radius) { return uniform(-radius, radius); }
  /// In {0, ..., n-1}, unbiased: incomplete last runs of n are drawn again. Requires: n > 0.
  std::uint64_t below(std::uint64_t n)
  {
    std::uint64_t const unusable = (0 - n) % n;  // 2^64 mod n
    for (;;)
      if (auto const b = bits(); b >= unusable) return b % n;
  }
  int between(int lo, int hi) { return lo + static_cast<int>(below(static_cast<std::uint64_t>(hi - lo) + 1)); }

private:
  static constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;

  static constexpr std::uint64_t mix(std::uint64_t z)
  {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }
  static constexpr std::uint64_t hash(std::string_view text)  // FNV-1a
  {
    std::uint64_t h = 0xCBF29CE484222325;
    for (char const c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001B3;
    return h;
  }

  std::uint64_t state_;
};

}  // namespace visibility::generators
