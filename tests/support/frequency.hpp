#pragma once

#include "support/random.hpp"

#include <algorithm>
#include <cmath>

/// Simulation against probabilities. Six standard deviations: a right value fails once in 5 * 10^8 seeds.
namespace visibility::test {

inline constexpr double sigmas = 6;

/// How often something happened. The score (Wilson) interval says for which probabilities that speaks.
struct Frequency {
  int trials, hits = 0;
  double share() const { return static_cast<double>(hits) / trials; }
  bool speaks_for(double p) const
  {
    return std::abs(hits - trials * p) <= sigmas * std::sqrt(trials * std::max(p * (1 - p), 0.0)) + 1e-9 * trials;
  }
  bool speaks_against_at_least(double p) const { return hits < trials * p && !speaks_for(p); }
  bool speaks_against_at_most(double p) const { return hits > trials * p && !speaks_for(p); }
};

template <class Event>
Frequency frequency(int trials, Event const& event)
{
  Frequency f{trials};
  for (int i = 0; i < trials; ++i) f.hits += event();
  return f;
}

/// Sample mean with its standard error.
struct Mean {
  double sum = 0, squares = 0;
  int n = 0;
  void add(double x) { sum += x, squares += x * x, ++n; }
  double average() const { return sum / n; }
  double error() const { return std::sqrt(std::max(0.0, squares / n - average() * average()) / n); }
  bool speaks_for(double mean) const { return std::abs(average() - mean) <= sigmas * error() + 1e-12; }
};

/// A random number with Poisson distribution: arrivals of a process of rate 1 before time `mean`.
inline int poisson(Random& random, double mean)
{
  int n = 0;
  for (double left = mean; (left += std::log1p(-random.unit())) > 0;) ++n;
  return n;
}

}  // namespace visibility::test
