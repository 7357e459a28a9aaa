#include "meshes.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/scene/footprint.hpp"

#include <cmath>

using namespace visibility;
using namespace visibility::test;

namespace {

RationalNumber doubled_area(Ring const& ring)
{
  RationalNumber sum(0);
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    auto const &a = ring[i], &b = ring[(i + 1) % n];
    sum += RationalNumber(a.x) * RationalNumber(b.y) - RationalNumber(b.x) * RationalNumber(a.y);
  }
  return sum;
}

RationalNumber doubled_area(std::vector<ConvexPrism> const& pieces)
{
  RationalNumber sum(0);
  for (auto const& p : pieces) sum += doubled_area(p.footprint);
  return sum;
}

}  // namespace

TEST_CASE("convex partition: pieces are convex and add up to the polygon exactly", "[scene][law]")
{
  auto const seed = GENERATE(range(1, 41));
  CAPTURE(seed);
  Random random(static_cast<std::uint64_t>(seed));
  Prism prism{{star(random, random.between(3, 40), 20, 100)}, 0, 10};
  RationalNumber expected = doubled_area(prism.rings[0]);
  if (seed % 2 == 0) {
    prism.rings.push_back(star(random, random.between(3, 20), 1, 5));
    expected -= doubled_area(prism.rings[1]);
  }
  if (seed % 3 == 0) std::reverse(prism.rings[0].begin(), prism.rings[0].end());
  auto const pieces = convex_partition(prism);
  REQUIRE_FALSE(pieces.empty());
  for (auto const& p : pieces) p.validate();
  REQUIRE(doubled_area(pieces) == expected);
}

TEST_CASE("convex partition: a convex footprint is one piece", "[scene]")
{
  REQUIRE(convex_partition({{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, 0, 1}).size() == 1);
  // Collinear points on the walls stay.
  REQUIRE(convex_partition({{{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}}, 0, 1}).size() == 1);
  REQUIRE(convex_partition({{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}, 0, 1}).size() == 2);  // an L
}

TEST_CASE("convex partition: what is not a polygon with holes is not taken for solid", "[scene][degenerate]")
{
  Ring const square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  auto const pieces = [](std::vector<Ring> rings) { return convex_partition({std::move(rings), 0, 1}).size(); };
  REQUIRE(pieces({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}) == 0);                  // crosses itself
  REQUIRE(pieces({{{0, 0}, {2, 2}, {4, 4}, {4, 0}, {2, 2}, {0, 4}}}) == 0);  // two lobes of opposite turn
  REQUIRE(pieces({{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}}) == 2);  // touches itself: fine
  REQUIRE(pieces({{{0, 0}, {1, 1}, {2, 2}}}) == 0);                          // no area
  REQUIRE(pieces({square, {{1, 1}, {5, 1}, {5, 2}, {1, 2}}}) == 0);          // hole crosses the ring
  REQUIRE(pieces({square, {{5, 5}, {6, 5}, {6, 6}, {5, 6}}}) == 0);          // hole outside
  REQUIRE(pieces({square, {{0, 1}, {1, 1}, {1, 2}, {0, 2}}}) == 0);          // hole shares a stretch of wall
  REQUIRE(pieces({square, square}) == 0);                                    // hole is everything
  REQUIRE(pieces({square, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}, {{2, 2}, {2.5, 2}, {2.5, 2.5}, {2, 2.5}}}) == 0);
  REQUIRE(pieces({square, {{0, 0}, {1, 1}, {1, 2}}}) > 0);  // hole touches in a point: fine
  REQUIRE(convex_partition({{square}, 1, 1}).empty());
}

TEST_CASE("footprint: the partition depends neither on where the ring starts nor on what the heap looks like",
          "[scene][law][degenerate]")
{
  // Corners on circles, of which every diagonal is as good as another: a comb of squares, a regular octagon on the
  // grid.
  Ring comb;
  for (int i = 0; i < 6; ++i)
    for (auto const& p : {Point2d{2.0 * i, 1}, Point2d{2.0 * i, 2}, Point2d{2.0 * i + 1, 2}, Point2d{2.0 * i + 1, 1}})
      comb.push_back(p);
  comb.push_back({11, 0});
  comb.push_back({0, 0});
  Ring const octagon{{3, 0}, {7, 0}, {10, 3}, {10, 7}, {7, 10}, {3, 10}, {0, 7}, {0, 3}, {4, 5}};
  for (Ring ring : {comb, octagon}) {
    auto const footprints = [&] {
      std::vector<std::vector<Point2d>> out;
      for (auto& piece : convex_partition({{ring}, 0, 1})) out.push_back(piece.footprint);
      return out;
    };
    auto const expected = footprints();
    REQUIRE(expected.size() > 1);
    std::vector<std::vector<char>> litter;
    for (std::size_t i = 0; i < 40; ++i) {
      for (std::size_t k = 0; k < 20; ++k) litter.emplace_back(64 + 48 * ((i * 7 + k * 13) % 29));
      if (i % 3 == 0) litter.erase(litter.begin(), litter.begin() + static_cast<std::ptrdiff_t>(litter.size() / 2));
      std::ranges::rotate(ring, ring.begin() + 1);
      REQUIRE(footprints() == expected);
    }
  }
}
