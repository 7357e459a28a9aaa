#include "windows.hpp"

#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::extended_projection;

namespace {

/// Depths of few values, so that rows repeat, some empty.
DepthMap<float> any_map(Random& random)
{
  DepthMap<float> map(random.between(1, 40), random.between(1, 20));
  double const empty = random.uniform(0, 0.4), repeated = random.uniform(0, 1);
  for (int y = 0; y < map.height(); ++y) {
    if (y > 0 && random.chance(repeated)) {
      std::copy_n(map.row(y - 1), map.width(), map.row(y));
      continue;
    }
    for (int x = 0; x < map.width(); ++x)
      if (!random.chance(empty)) map.row(y)[x] = static_cast<float>(random.between(0, 9));
  }
  return map;
}

/// Windows in [0, count): of like sizes and ascending, as those of pixels are, or anything; some empty.
std::vector<Window> any_windows(Random& random, int count)
{
  std::vector<Window> out(static_cast<std::size_t>(random.between(1, 40)));
  bool const are_alike = random.chance(0.5);
  int const size = random.between(1, count);
  int first = 0;
  for (auto& w : out) {
    if (random.chance(0.1)) continue;
    int const n = are_alike ? std::max(1, size - random.below(2)) : random.between(1, count);
    first = are_alike ? std::min(first + random.below(2), count - n) : random.between(0, count - n);
    w = {first, first + n - 1};
  }
  return out;
}

float farthest(DepthMap<float> const& map, Window const& columns, Window const& rows)
{
  float depth = columns.is_empty() || rows.is_empty() ? DepthMap<float>::empty : 0;
  for (int y = rows.first; y <= rows.last; ++y)
    for (int x = columns.first; x <= columns.last; ++x) depth = std::max(depth, map.at(x, y));
  return depth;
}

}  // namespace

TEST_CASE("occlusion sweep: farthest_in_windows is the maximum over each window", "[methods][law]")
{
  int covered = 0;
  for (int trial = 0; trial < trials(2000); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    auto const map = any_map(random);
    auto const columns = any_windows(random, map.width()), rows = any_windows(random, map.height());
    auto const out = farthest_in_windows(map, columns, rows);
    REQUIRE(out.width() == static_cast<int>(columns.size()));
    REQUIRE(out.height() == static_cast<int>(rows.size()));
    for (int y = 0; y < out.height(); ++y)
      for (int x = 0; x < out.width(); ++x) {
        float const expected = farthest(map, columns[static_cast<std::size_t>(x)], rows[static_cast<std::size_t>(y)]);
        REQUIRE(out.at(x, y) == expected);
        covered += expected < DepthMap<float>::empty;
      }
  }
  REQUIRE(covered > trials(10'000));
}
