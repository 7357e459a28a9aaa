#pragma once

#include "visibility/kernel/arithmetic.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace visibility::bench {

/// One layer alone, to see what each costs. Where it cannot tell it says zero.
struct IntervalOnly {
  static constexpr std::string_view name = "interval-layer";
  static constexpr bool is_exact = false;
  template <class F, class... X>
  static Sign sign(F const& f, X... x)
  {
    return layers::interval(f, x...).value_or(Sign::zero);
  }
};
struct ExactOnly {
  static constexpr std::string_view name = "exact-layer";
  static constexpr bool is_exact = true;
  template <class F, class... X>
  static Sign sign(F const& f, X... x)
  {
    return layers::exact(f, x...);
  }
};

/// Registers "subject/family/arithmetic": `ask.template operator()<A>(query)` on all queries in turn. Before it is
/// timed, every exact arithmetic must give the same answers as `Rational`. Counters: ns per query, and which share of
/// the signs each layer decides (of `Filtered`), per query.
template <class A, class Query, class Ask>
void add(std::string const& subject, std::string const& family, std::vector<Query> const& queries, Ask const& ask)
{
  auto const full_name = subject + "/" + family + "/" + std::string(A::name);
  int wrong = 0;
  for (auto const& q : queries) wrong += ask.template operator()<A>(q) != ask.template operator()<Rational>(q);
  if (A::is_exact && wrong > 0) {
    std::fprintf(stderr, "%s: %d wrong answers\n", full_name.c_str(), wrong);
    std::exit(1);
  }
  ThreadTally::reset();
  for (auto const& q : queries) benchmark::DoNotOptimize(ask.template operator()<TalliedFiltered>(q));
  LayerCounts const layers = ThreadTally::counts;
  benchmark::RegisterBenchmark(full_name.c_str(), [=](benchmark::State& state) {
    for (auto _ : state)
      for (auto const& q : queries) benchmark::DoNotOptimize(ask.template operator()<A>(q));
    double const n = static_cast<double>(queries.size());
    state.counters["per_query"] =
      benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["wrong"] = wrong;
    state.counters["filter"] = static_cast<double>(layers.filter) / n;
    state.counters["interval"] = static_cast<double>(layers.interval) / n;
    state.counters["exact"] = static_cast<double>(layers.exact) / n;
  });
}

template <class Query, class Ask>
void add_all(std::string const& subject, std::string const& family, std::vector<Query> const& queries, Ask const& ask)
{
  add<Double>(subject, family, queries, ask);
  add<Filtered>(subject, family, queries, ask);
  add<Rational>(subject, family, queries, ask);
  add<IntervalOnly>(subject, family, queries, ask);
  add<ExactOnly>(subject, family, queries, ask);
}

inline int run(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace visibility::bench
