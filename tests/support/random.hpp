#pragma once

#include "visibility/kernel/point.hpp"

#include <cstdint>
#include <random>

namespace visibility::test {

/// Random numbers that are the same on every machine: std::mt19937_64 with distributions of our own.
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  int between(int lo, int hi) { return lo + below(hi - lo + 1); }
  bool chance(double p) { return unit() < p; }
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  ///< [0, 1)
  double uniform(double lo, double hi) { return lo + (hi - lo) * unit(); }
  Point3d point(double lo, double hi) { return {uniform(lo, hi), uniform(lo, hi), uniform(lo, hi)}; }
  /// A point of the integer grid {lo, ..., hi}^3: shared planes, edges and corners are common.
  Point3d grid_point(int lo, int hi)
  {
    return {double(between(lo, hi)), double(between(lo, hi)), double(between(lo, hi))};
  }

private:
  std::mt19937_64 engine_;
};

}  // namespace visibility::test
