/// Cones of portal sequences and the decision whether they hold a strict stabbing line, per number type.
///
/// 64 sequences per size and family, seed 3 (tests/line_space/portal_families.hpp); n half-spaces = 2 edges, (n - 6) /
/// 3 occluders, the verticals through their ends, and points further out to fill up. Families:
///   random          full mantissas
///   nearly_aligned  one plane, single coordinates off by one ulp
/// Rows: cone (double description alone), decide (cone, rays, edges), find (decide and a rational line). Counters: time
/// per sequence, rays of the average cone, decisions that differ from the exact one ("wrong").
#include "harness.hpp"
#include "line_space/portal_families.hpp"
#include "visibility/line_space/portal_half_spaces.hpp"

#include <CGAL/Gmpz.h>

using namespace visibility;
using namespace visibility::bench;

namespace {

constexpr int count = 64;
constexpr std::uint64_t seed = 3;

/// Sequences of exactly n half-spaces: as many occluders as fit, filled up with points further out.
std::vector<PortalSequence> sequences(test::PortalFamily family, int n)
{
  test::PortalSource source(family, seed);
  std::vector<PortalSequence> list;
  while (list.size() < count) {
    auto s = source.sequence((n - 6) / 3);
    for (int i = 0; i < (n - 6) % 3; ++i) {
      auto const& e = i == 0 ? s.source : s.target;
      s.points.push_back({{2 * e.left.x - e.right.x, 2 * e.left.y - e.right.y}, PortalSequence::Side::left});
    }
    list.push_back(s);
  }
  return list;
}

template <class NT>
using HalfSpaces = std::vector<std::vector<PluckerLine<NT>>>;

template <class NT>
HalfSpaces<NT> half_spaces(std::vector<PortalSequence> const& list)
{
  HalfSpaces<NT> result;
  for (auto const& s : list) result.push_back(portal_half_spaces<NT>(s, integer_frame(s)));
  return result;
}

template <class NT>
std::span<PluckerLine<NT> const> view(std::vector<PluckerLine<NT>> const& h)
{
  return h;
}

void set_per_sequence(benchmark::State& state)
{
  state.counters["per_sequence"] =
    benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class NT>
void add_rows(std::string const& type, std::string const& where, std::vector<PortalSequence> const& list)
{
  auto const lines = half_spaces<NT>(list);
  int wrong = 0;
  double rays = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    wrong += has_strict_stabbing_line(view(lines[i]), SearchDepth::edges) != has_sight_line<RationalNumber>(list[i]);
    rays += static_cast<double>(PluckerCone<NT>(view(lines[i])).rays().size()) / count;
  }
  if (!std::is_same_v<NT, double> && wrong > 0) {
    std::fprintf(stderr, "%s: %d wrong answers\n", type.c_str(), wrong);
    std::exit(1);
  }
  benchmark::RegisterBenchmark(("cone/" + where + "/" + type).c_str(), [=](benchmark::State& state) {
    for (auto _ : state)
      for (auto const& h : lines) benchmark::DoNotOptimize(PluckerCone<NT>(view(h)).rays().size());
    set_per_sequence(state);
    state.counters["rays"] = rays;
  });
  benchmark::RegisterBenchmark(("decide/" + where + "/" + type).c_str(), [=](benchmark::State& state) {
    for (auto _ : state)
      for (auto const& h : lines) benchmark::DoNotOptimize(has_strict_stabbing_line(view(h), SearchDepth::edges));
    set_per_sequence(state);
    state.counters["wrong"] = wrong;
  });
}

void add_find(std::string const& where, std::vector<PortalSequence> const& list)
{
  benchmark::RegisterBenchmark(("find/" + where + "/ExactNumber").c_str(), [=](benchmark::State& state) {
    for (auto _ : state)
      for (auto const& s : list) benchmark::DoNotOptimize(find_sight_line(s).has_value());
    set_per_sequence(state);
  });
}

}  // namespace

int main(int argc, char** argv)
{
  for (auto const family : {test::PortalFamily::random, test::PortalFamily::nearly_aligned})
    for (int const n : {8, 16, 24, 32}) {
      auto const list = sequences(family, n);
      std::string const where = std::string(test::name(family)) + "/" + std::to_string(n);
      add_rows<double>("double", where, list);
      add_rows<ExactNumber>("ExactNumber", where, list);
      add_rows<CGAL::Gmpz>("Gmpz", where, list);
      add_rows<RationalNumber>("Gmpq", where, list);
      add_find(where, list);
    }
  return run(argc, argv);
}
