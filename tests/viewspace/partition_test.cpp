#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/viewspace/partition.hpp"

#include <algorithm>

using namespace visibility;
using test::Random;

namespace {

double volume(Box const& b) { return (b.max.x - b.min.x) * (b.max.y - b.min.y) * (b.max.z - b.min.z); }

bool inside(Box const& inner, Box const& outer) { return contains(outer, inner.min) && contains(outer, inner.max); }

Partition partition(Box const& region, std::vector<Point3d> const& sizes) { return Partition(region, sizes); }

}  // namespace

TEST_CASE("partition: the paper's square of 400 has 25 cells of 80 and 400 of 20, sixteen in each", "[viewspace]")
{
  auto const p = partition({{-200, -200, 0}, {200, 200, 50}}, {{80, 80, 50}, {20, 20, 50}});
  REQUIRE(p.levels() == 2);
  REQUIRE(p.cell_count(0) == 25);
  REQUIRE(p.cell_count(1) == 400);
  REQUIRE(p.cell(0, 0) == Box{{-200, -200, 0}, {-120, -120, 50}});
  REQUIRE(p.cell(1, 21) == Box{{-180, -180, 0}, {-160, -160, 50}});
  for (std::size_t i = 0; i < 25; ++i) REQUIRE(p.children(0, i).size() == 16);
}

TEST_CASE("partition: cells tile the region, children their parent, on shared boundaries", "[viewspace][law]")
{
  auto const seed = GENERATE(range(1, 41));
  CAPTURE(seed);
  Random random(static_cast<std::uint64_t>(seed));
  Point3d const low = random.point(-1e3, 1e3), extent = random.point(0.5, 40);
  Box const region{low, {low.x + extent.x, low.y + extent.y, low.z + extent.z}};
  Point3d const size = random.point(3, 50);
  std::vector<Point3d> const sizes{size, {size.x * random.uniform(0.2, 1), size.y / 3, size.z * 0.7}};
  Partition const p(region, sizes);
  for (std::size_t level = 0; level < p.levels(); ++level) {
    double sum = 0;
    Box all;
    std::vector<double> starts;
    for (std::size_t i = 0; i < p.cell_count(level); ++i) {
      Box const c = p.cell(level, i);
      REQUIRE(c.has_interior());
      REQUIRE(c.max.x - c.min.x <= sizes[level].x * (1 + 1e-12));
      all.extend(c);
      sum += volume(c);
      // Each face that is not on the region's surface is the face of a neighbour, bit for bit.
      bool const shared = c.max.x == region.max.x || [&] {
        Box const next = p.cell(level, i + 1);
        return next.min.x == c.max.x && next.min.y == c.min.y && next.max.z == c.max.z;
      }();
      REQUIRE(shared);
    }
    REQUIRE(all == region);
    REQUIRE(sum == Approx(volume(region)));
  }
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < p.cell_count(0); ++i) {
    double sum = 0;
    for (auto const c : p.children(0, i)) {
      REQUIRE(inside(p.cell(1, c), p.cell(0, i)));
      sum += volume(p.cell(1, c));
      seen.push_back(c);
    }
    REQUIRE(sum == Approx(volume(p.cell(0, i))));
  }
  std::ranges::sort(seen);
  REQUIRE(seen.size() == p.cell_count(1));
  REQUIRE(std::ranges::adjacent_find(seen) == seen.end());
}

TEST_CASE("partition: sizes that divide the region only up to rounding do not cost a cell more",
          "[viewspace][degenerate]")
{
  REQUIRE(partition({{0, 0, 0}, {1.1, 0.3, 0.7}}, {{0.1, 0.1, 0.1}}).cell_count(0) == 11 * 3 * 7);
  REQUIRE(partition({{0, 0, 0}, {1, 1, 1}}, {{5, 5, 5}}).cell_count(0) == 1);
}

TEST_CASE("partition: says what is wrong with a request", "[viewspace]")
{
  Box const unit{{0, 0, 0}, {1, 1, 1}};
  REQUIRE_THROWS_AS(partition({{0, 0, 0}, {1, 0, 1}}, {{1, 1, 1}}), std::invalid_argument);
  REQUIRE_THROWS_AS(partition({{0, 0, 0}, {HUGE_VAL, 1, 1}}, {{1, 1, 1}}), std::invalid_argument);
  REQUIRE_THROWS_AS(partition(unit, {}), std::invalid_argument);
  REQUIRE_THROWS_AS(partition(unit, {{1, 0, 1}}), std::invalid_argument);
  REQUIRE_THROWS_AS(partition(unit, {{1, std::nan(""), 1}}), std::invalid_argument);
  REQUIRE_THROWS_AS(partition(unit, {{0.5, 1, 1}, {0.6, 1, 1}}), std::invalid_argument);
  REQUIRE_THROWS_AS(partition(unit, {{1e-4, 1e-4, 1e-4}}), std::invalid_argument);
  REQUIRE_THROWS_AS(partition({{1e16, 0, 0}, {1e16 + 8, 1, 1}}, {{1, 1, 1}}), std::invalid_argument);
}
