#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/geometry/segment_box.hpp"
#include "visibility/kernel/arithmetic.hpp"
#include "visibility/scene/bounding_hierarchy.hpp"

#include <algorithm>

using namespace visibility;
using test::Random;

namespace {

/// Boxes of one family; scale 1 is a grid on which faces, edges and corners coincide.
std::vector<Box> boxes(Random& random, int n, bool grid)
{
  std::vector<Box> out;
  for (int i = 0; i < n; ++i) {
    Box b;
    for (int k = 0; k < 2; ++k) b.extend(grid ? random.grid_point(0, 8) : random.point(-1e3, 1e3));
    if (!grid && random.chance(0.5)) b.max = {b.min.x + 1, b.min.y + 1, b.min.z + 1};
    out.push_back(b);
  }
  return out;
}

}  // namespace

TEST_CASE("bounding hierarchy: finds every box along a segment and every box that meets a box", "[scene][conservative]")
{
  auto const seed = GENERATE(range(1, 13));
  CAPTURE(seed);
  Random random(static_cast<std::uint64_t>(seed));
  bool const grid = seed % 2 == 0;
  auto const all = boxes(random, random.between(1, 300), grid);
  BoundingHierarchy const hierarchy(all);
  hierarchy.validate(all);
  std::size_t met = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Point3d const p = grid ? random.grid_point(-1, 9) : random.point(-1e3, 1e3);
    Point3d const q = grid ? random.grid_point(-1, 9) : random.point(-1e3, 1e3);
    if (p == q) continue;
    std::vector<bool> found(all.size(), false);
    hierarchy.any_along(SegmentProbe(p, q), [&](auto i) { return found[i] = true, false; });
    Box query;
    query.extend(p);
    query.extend(q);
    std::vector<bool> touched(all.size(), false);
    hierarchy.any_meeting(query, [&](auto i) { return touched[i] = true, false; });
    std::vector<bool> exactly(all.size(), false);
    hierarchy.any_item_meeting(query, [&](auto i) { return exactly[i] = true, false; });
    for (std::size_t i = 0; i < all.size(); ++i) {
      REQUIRE(exactly[i] == meet(all[i], query));
      if (segment_meets<Rational>(all[i], exact(p), exact(q))) REQUIRE((++met, found[i]));
      if (meet(all[i], query)) REQUIRE(touched[i]);
    }
  }
  REQUIRE(met > 0);
}

TEST_CASE("bounding hierarchy: a segment probe never misses a box that the segment touches", "[scene][conservative]")
{
  // Segments through or along corners, at scales where products underflow or overflow.
  auto const scale = GENERATE(1.0, 0x1p-1070, 0x1p-540, 0x1p-500, 0x1p300, 0x1p520, 0x1p1018);
  CAPTURE(scale);
  Random random(7);
  int misses = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    auto const point = [&](double s) {
      auto const g = random.grid_point(-4, 4);
      return Point3d{g.x * s, g.y * (random.chance(0.1) ? 1.0 : s), g.z * s};
    };
    Box b;
    b.extend(point(scale));
    b.extend(point(scale));
    Point3d const p = point(scale), q = point(scale);
    if (p == q) continue;
    bool const skipped = SegmentProbe(p, q).certainly_misses(b);
    misses += skipped;
    if (skipped) REQUIRE_FALSE(segment_meets<Rational>(b, exact(p), exact(q)));
  }
  REQUIRE(misses > 0);  // it does cull
}

TEST_CASE("bounding hierarchy: front-to-back reaches every item once and drops what is not entered", "[scene]")
{
  Random random(3);
  auto const all = boxes(random, 500, false);
  BoundingHierarchy const hierarchy(all);
  Box const region{{-10, -10, -10}, {10, 10, 10}};
  std::vector<int> visits(all.size(), 0);
  std::vector<std::uint32_t> order;
  hierarchy.front_to_back(
    region, [](auto, Box const&) { return true; }, [&](auto i) { ++visits[i], order.push_back(i); });
  REQUIRE(order.front() == hierarchy.nearest_item(0, region));
  REQUIRE(std::ranges::all_of(visits, [](int n) { return n == 1; }));
  hierarchy.front_to_back(
    region, [](auto, Box const&) { return false; }, [](auto) { FAIL("visited a dropped node"); });
}

TEST_CASE("bounding hierarchy: identical and empty inputs are fine", "[scene][degenerate]")
{
  BoundingHierarchy const none{std::span<Box const>{}};
  REQUIRE(none.nodes().empty());
  REQUIRE_FALSE(none.any_meeting(Box{{0, 0, 0}, {1, 1, 1}}, [](auto) { return true; }));
  std::vector<Box> const same(10'000, Box{{1, 2, 3}, {1, 2, 3}});
  BoundingHierarchy const hierarchy(same);
  hierarchy.validate(same);
  int found = 0;
  hierarchy.any_along(SegmentProbe({0, 0, 0}, {2, 4, 6}), [&](auto) { return ++found, false; });
  REQUIRE(found == 10'000);
}

TEST_CASE("bounding hierarchy: carried further, a node keeps its place and holds the items of its groups",
          "[scene][law]")
{
  auto const seed = GENERATE(range(1, 13));
  CAPTURE(seed);
  Random random(static_cast<std::uint64_t>(seed));
  auto const items = boxes(random, random.between(1, 400), seed % 2 == 0);
  std::vector<std::uint32_t> first{0};
  std::vector<Box> groups;
  while (first.back() < items.size()) {
    auto const next =
      std::min<std::size_t>(items.size(), first.back() + static_cast<std::size_t>(random.between(1, seed)));
    groups.emplace_back();
    for (auto i = first.back(); i < next; ++i) groups.back().extend(items[i]);
    first.push_back(static_cast<std::uint32_t>(next));
  }
  BoundingHierarchy const coarse(groups), fine(coarse, first, items);
  fine.validate(items);
  auto const below = [](BoundingHierarchy const& tree, std::uint32_t node) {
    std::vector<std::uint32_t> out, stack{node};
    while (!stack.empty()) {
      auto const& n = tree.nodes()[stack.back()];
      stack.pop_back();
      if (n.is_leaf())
        out.insert(out.end(), tree.items().begin() + n.first, tree.items().begin() + n.first + n.count);
      else
        stack.insert(stack.end(), {n.first, n.first + 1});
    }
    std::ranges::sort(out);
    return out;
  };
  for (std::uint32_t n = 0; n < coarse.nodes().size(); ++n) {
    std::vector<std::uint32_t> expected;
    for (auto const g : below(coarse, n))
      for (auto i = first[g]; i < first[g + 1]; ++i) expected.push_back(i);
    REQUIRE(below(fine, n) == expected);
    REQUIRE(fine.nodes()[n].bounds == coarse.nodes()[n].bounds);
  }
}
