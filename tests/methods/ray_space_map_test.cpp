#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/methods/ray_space/occlusion_map.hpp"

#include <cmath>
#include <limits>
#include <vector>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::ray_space;

namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

GateEnd any_end(Random& random, bool steep)
{
  auto const number = [&](double most) { return static_cast<float>(random.uniform(-most, most)); };
  GateEnd e{number(2), number(10), number(2)};
  if (steep) e.slope = random.chance(0.5) ? 1e30F : -1e30F;
  return e;
}

/// Mostly walls from below the cell to above it, so that something is hidden.
Gate any_gate(Random& random)
{
  Gate g{any_end(random, random.chance(0.02)), any_end(random, random.chance(0.02)),
         static_cast<float>(random.uniform(0, 20))};
  if (random.chance(0.7)) g.top.slope = std::fabs(g.top.slope), g.top.base += 12;
  if (random.chance(0.3)) g.bottom = open_bottom;
  if (random.chance(0.1)) g.beyond = nowhere;
  return g;
}

Extent any_extent(Random& random)
{
  auto const near = static_cast<float>(random.uniform(0, 60)), low = static_cast<float>(random.uniform(-20, 40));
  auto const wide = [&] { return static_cast<float>(random.chance(0.2) ? 0 : random.uniform(0, 10)); };
  Extent e{near, near + wide(), low, low + wide()};
  if (random.chance(0.02)) e.far = 1e30F;
  return e;
}

/// One pixel by itself, without rounding: products of floats are exact. By how much the gate reaches beyond the extent.
double excess(OcclusionMap const& map, int row, int column, Extent const& e)
{
  double best = -HUGE_VAL;
  for (int k = 0; k < map.components(); ++k) {
    Gate const g = map.gate(row, column, k);
    if (!(e.near > g.beyond)) continue;
    double over = HUGE_VAL;
    for (double const u : {double(e.near), double(e.far)}) {
      over = std::min(over, double(g.top.base) + double(g.top.slope) * u - double(e.high));
      if (!reaches_ground(g))
        over = std::min(over, double(e.low) - (double(g.bottom.base) + double(g.bottom.slope) * u));
    }
    best = std::max(best, over);
  }
  return best;
}

}  // namespace

TEST_CASE("ray-space map: the pyramid and the pixels one by one give one answer", "[methods][oracle]")
{
  int hidden = 0, visible = 0;
  for (int trial = 0; trial < trials(60); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    int const columns = random.between(1, 70), rows = random.between(1, 4);
    Frame const frame(Box{{-5, -3, 0}, {5, 3, 2}}, random.between(0, 3), rows, columns);
    OcclusionMap map(frame, random.between(1, 5));
    for (int round = 0; round < 40; ++round) {
      int const row = random.between(0, rows - 1), from = random.between(0, columns - 1);
      int const to = random.between(from + 1, columns);
      std::vector<Gate> gates;
      Gate const wall = any_gate(random);
      for (int c = from; c < to; ++c) gates.push_back(random.chance(0.8) ? wall : any_gate(random));
      map.insert(row, from, gates);
      for (int question = 0; question < 6; ++question) {
        Extent const e = any_extent(random);
        int const asked = random.between(0, rows - 1), first = random.between(0, columns - 1);
        int const last = random.between(first + 1, columns);
        std::vector<std::int32_t> open(static_cast<std::size_t>(last - first), 7);
        bool const any = map.visible_pixels(asked, first, last, e, open.data());
        int const found = map.first_visible(asked, first, last, e);
        int expected = last;
        for (int c = last - 1; c >= first; --c) {
          auto const is_open = open[static_cast<std::size_t>(c - first)];
          REQUIRE((is_open == 0 || is_open == -1));
          if (is_open != 0) expected = c;
          double const by = excess(map, asked, c, e);
          if (is_open == 0) CHECK(by > 0);
          // Rounding to the safe side leaves out no more than what is hidden by a hair, or is out of all proportion.
          if (by > 1e-3 && e.far < 1e18F) CHECK(is_open == 0);
          ++(is_open == 0 ? hidden : visible);
        }
        CHECK(found == expected);
        CHECK(any == (expected < last));
      }
    }
  }
  CHECK(hidden > trials(1000));
  CHECK(visible > trials(1000));
}
