#pragma once

#include "strategies.hpp"

namespace visibility::detail {

/// Shares rays among the strategies by their recent success; every one keeps a minimal share, since what pays changes
/// as the easy objects are found.
class Bandit {
public:
  Bandit() { rate_.fill(1); }

  Strategy choose(Random& random) const
  {
    double total = 0;
    for (double const r : rate_) total += r;
    if (!(total > 0) || random.chance(minimal_share * strategies))
      return static_cast<Strategy>(random.below(strategies));
    double x = random.unit() * total;
    for (std::size_t i = 0; i + 1 < strategies; ++i)
      if ((x -= rate_[i]) < 0) return static_cast<Strategy>(i);
    return static_cast<Strategy>(strategies - 1);
  }

  /// After a round: rays cast and what they were worth.
  void learn(std::array<std::uint64_t, strategies> const& cast, std::array<double, strategies> const& worth)
  {
    for (std::size_t i = 0; i < strategies; ++i) {
      cast_[i] = memory * cast_[i] + static_cast<double>(cast[i]);
      worth_[i] = memory * worth_[i] + worth[i];
      rate_[i] = (worth_[i] + prior) / (cast_[i] + prior);
    }
  }

private:
  static constexpr double minimal_share = 0.04, memory = 0.9;
  static constexpr double prior = 0.5;  // without finds the shares drift back to equal ones
  std::array<double, strategies> cast_{}, worth_{}, rate_{};
};

}  // namespace visibility::detail
