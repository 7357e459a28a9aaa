#pragma once

#include "support/catch.hpp"
#include "support/recipes.hpp"
#include "support/trials.hpp"
#include "visibility/kernel/arithmetic.hpp"

#include <map>

namespace visibility::test {

/// What one recipe did to a predicate.
struct Outcome {
  LayerCounts layers;
  std::array<int, 3> signs{};  ///< negative, zero, positive
};

/// Asks the formula on `trials(base)` tuples of every recipe and requires Filtered == Rational, and that each layer
/// that certifies a sign certifies the right one. `arguments(source)` makes one tuple of coordinates.
template <class Formula, class Arguments>
std::map<Recipe, Outcome> check_agreement(Formula const& formula, Arguments const& arguments, int base = 2000)
{
  std::map<Recipe, Outcome> outcomes;
  for (Recipe const recipe : all_recipes) {
    std::uint64_t const seed = 1000 + static_cast<std::uint64_t>(recipe);
    CAPTURE(name(recipe), seed);
    PointSource source(recipe, seed);
    Outcome& outcome = outcomes[recipe];
    ThreadTally::reset();
    int wrong = 0;
    for (int i = 0, n = trials(base); i < n; ++i)
      std::apply(
        [&](auto... x) {
          Sign const truth = Rational::sign(formula, x...);
          auto const differs = [&](MaybeSign s) { return s && *s != truth; };
          wrong += TalliedFiltered::sign(formula, x...) != truth || differs(layers::filter(formula, x...)) ||
                   differs(layers::interval(formula, x...)) || layers::exact(formula, x...) != truth;
          ++outcome.signs[static_cast<std::size_t>(static_cast<int>(truth) + 1)];
        },
        arguments(source));
    outcome.layers = ThreadTally::counts;
    REQUIRE(wrong == 0);
  }
  return outcomes;
}

/// The layer that decides one query.
template <class Ask>
Layer deciding_layer(Ask const& ask)
{
  ThreadTally::reset();
  ask();
  REQUIRE(ThreadTally::counts.total() == 1);
  return ThreadTally::counts.filter == 1     ? Layer::filter
         : ThreadTally::counts.interval == 1 ? Layer::interval
                                             : Layer::exact;
}

}  // namespace visibility::test
