#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/evidence/check.hpp"
#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/moving_objects.hpp"
#include "visibility/viewspace/divide.hpp"
#include "visibility/viewspace/preprocess.hpp"

#include <oneapi/tbb/global_control.h>

using namespace visibility;

namespace {

static_assert(RestrictableMethod<ExtendedProjection> && RestrictableMethod<OcclusionSweep>);
static_assert(RefinableMethod<StrongOcclusion<>> && !RestrictableMethod<StrongOcclusion<>>);

extended_projection::Options coarse()
{
  extended_projection::Options o;
  o.resolution = 64;
  o.planes = 4;
  return o;
}

/// Two initial cells of a small city: a box, and a street at an angle.
struct City {
  Scene scene = generate("city,n=300");
  PreparedScene prepared{scene};
  HeightField field{scene};
  std::vector<std::uint64_t> polygons = polygon_counts(scene);
  std::vector<ViewCell> initial{ViewCell(Box{{-180, -180, 0}, {-60, -100, 2}}),
                                ViewCell::hull(std::vector<Point3d>{{10.1, 10.3, 0},
                                                                    {90.7, 30.9, 0},
                                                                    {87.3, 44.1, 0},
                                                                    {6.9, 23.7, 0},
                                                                    {10.1, 10.3, 2},
                                                                    {90.7, 30.9, 2},
                                                                    {87.3, 44.1, 2},
                                                                    {6.9, 23.7, 2}})};

  CellQuery exact() const
  {
    return
      [this](ViewCell const& cell, ParentCell const*) { return std::pair(Exact25d<>()(field, cell), CellState()); };
  }
  std::vector<std::pair<char const*, CellQuery>> queries() const
  {
    return {{"extended-projection", cell_query(prepared, ExtendedProjection(coarse()))},
            {"occlusion-sweep", cell_query(prepared, OcclusionSweep(coarse()))},
            {"strong-occlusion", cell_query(prepared, StrongOcclusion<>())},
            {"exact-2.5d", exact()}};
  }
};

constexpr PreprocessOptions options{.budget = 70, .min_size = 15};

}  // namespace

TEST_CASE("preprocess: leaves hold all that is visible from them, within the set of their initial cell",
          "[viewspace][conservative]")
{
  City const city;
  for (auto const& [name, query] : city.queries()) {
    CAPTURE(name);
    auto const cells = preprocess(query, city.initial, city.polygons, options);
    REQUIRE(cells.leaves.size() > city.initial.size());
    REQUIRE(cells.evaluated == 2 * cells.leaves.size() - city.initial.size());
    std::vector<PotentiallyVisibleSet> whole;
    for (auto const& c : city.initial) whole.push_back(query(divisible(c), nullptr).first);
    bool shrinks = false;
    for (auto const& leaf : cells.leaves) {
      auto const& set = leaf.set.set.visible;
      auto const exact = Exact25d<>()(city.field, leaf.cell).visible;
      REQUIRE(std::ranges::includes(set, exact));
      REQUIRE(std::ranges::includes(whole[leaf.initial].visible, set));
      if (leaf.set.set.guarantee == Guarantee::exact) REQUIRE(set == exact);
      shrinks = shrinks || set.size() < whole[leaf.initial].visible.size();
    }
    REQUIRE(shrinks);
  }
}

TEST_CASE("preprocess: a leaf keeps to the budget or could not be divided into cells that are large enough",
          "[viewspace]")
{
  City const city;
  for (std::uint64_t const budget : {40U, 70U, 120U, 1000U}) {
    PreprocessOptions const o{.budget = budget, .min_size = 15};
    auto const cells = preprocess(city.exact(), city.initial, city.polygons, o);
    for (auto const& leaf : cells.leaves) {
      std::uint64_t polygons = 0;
      for (auto const v : leaf.set.set.visible) polygons += city.polygons[v];
      REQUIRE(leaf.polygons == polygons);
      REQUIRE((polygons <= budget || longest_extent(leaf.cell) / 2 < o.min_size));
      REQUIRE(longest_extent(leaf.cell) >= o.min_size);
    }
    if (budget == 1000) REQUIRE(cells.leaves.size() == city.initial.size());
  }
}

TEST_CASE("preprocess: the leaves of a box tile it; each point of a polytope is in a leaf", "[viewspace][law]")
{
  City const city;
  auto const cells = preprocess(city.exact(), city.initial, city.polygons, options);
  double volume = 0;
  for (auto const& leaf : cells.leaves)
    if (leaf.initial == 0) {
      Box const& b = leaf.cell.bounds();
      volume += (b.max.x - b.min.x) * (b.max.y - b.min.y) * (b.max.z - b.min.z);
    }
  REQUIRE(volume == 120.0 * 80 * 2);  // exact in doubles
  test::Random random(1);
  for (int i = 0; i < 500; ++i) {
    Point3d const p = random.point(0, 100);
    Point3d const q{p.x, p.y / 2, p.z / 50};
    if (!contains(city.initial[1], q)) continue;
    REQUIRE(std::ranges::any_of(cells.leaves,
                                [&](LeafCell const& leaf) { return leaf.initial == 1 && contains(leaf.cell, q); }));
  }
}

TEST_CASE("preprocess: the number of threads changes nothing", "[viewspace][law]")
{
  City const city;
  auto const run = [&](std::size_t threads) {
    oneapi::tbb::global_control const limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
    return preprocess(cell_query(city.prepared, OcclusionSweep(coarse())), city.initial, city.polygons, options);
  };
  auto const one = run(1), several = run(7);
  REQUIRE(one.evaluated == several.evaluated);
  REQUIRE(one.leaves.size() == several.leaves.size());
  for (std::size_t i = 0; i < one.leaves.size(); ++i) {
    REQUIRE(one.leaves[i].cell.bounds() == several.leaves[i].cell.bounds());
    REQUIRE(one.leaves[i].set.set.visible == several.leaves[i].set.set.visible);
    REQUIRE(one.leaves[i].set.set.statistics == several.leaves[i].set.set.statistics);
  }
}

TEST_CASE("candidates: all of the scene as candidates changes nothing, and none gives none", "[viewspace][law]")
{
  City const city;
  std::vector<std::uint32_t> all(city.scene.objects.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  auto const holds = [&](auto const& method) {
    for (auto const& cell : city.initial) {
      REQUIRE(method(city.prepared, cell, all).visible == method(city.prepared, cell).visible);
      REQUIRE(method(city.prepared, cell, std::span<std::uint32_t const>()).visible.empty());
    }
  };
  holds(ExtendedProjection(coarse()));
  holds(OcclusionSweep(coarse()));
}

TEST_CASE("preprocess: refuses sets that may lack something, and a smallest size of zero", "[viewspace]")
{
  City const city;
  CellQuery const aggressive = [](ViewCell const&, ParentCell const*) {
    PotentiallyVisibleSet set;
    set.guarantee = Guarantee::aggressive;
    return std::pair(set, CellState());
  };
  REQUIRE_THROWS_AS(preprocess(aggressive, city.initial, city.polygons, options), std::invalid_argument);
  REQUIRE_THROWS_AS(preprocess(city.exact(), city.initial, city.polygons, {.budget = 1, .min_size = 0}),
                    std::invalid_argument);
}
