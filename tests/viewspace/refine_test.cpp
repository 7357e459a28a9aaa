#include "support/catch.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/viewspace/refine.hpp"

#include <oneapi/tbb/global_control.h>

#include <atomic>

using namespace visibility;
using strong_occlusion::Granularity;

namespace {

/// A small city of the paper, and a region in its free middle.
struct City {
  Scene scene = generate("city,n=400");
  PreparedScene prepared{scene};
  Box region{{-160, -160, 0}, {160, 160, 50}};

  std::vector<std::vector<CellSet>> sets(std::vector<Point3d> const& sizes, Granularity coarse) const
  {
    std::vector<StrongOcclusion<>> methods(sizes.size(), StrongOcclusion<>({.granularity = coarse}));
    methods.back() = StrongOcclusion<>();
    return refine(prepared, Partition(region, sizes), methods);
  }
};

}  // namespace

TEST_CASE("refine: every cell has the set it would have by itself", "[viewspace][law]")
{
  City const city;
  std::vector<Point3d> const sizes{{160, 160, 50}, {80, 80, 50}, {40, 20, 50}};
  Partition const partition(city.region, sizes);
  for (auto const coarse : {Granularity::object, Granularity::part, Granularity::face}) {
    auto const sets = city.sets(sizes, coarse);
    for (std::size_t level = 0; level < sets.size(); ++level)
      for (std::size_t i = 0; i < sets[level].size(); ++i) {
        CAPTURE(level, i);
        StrongOcclusion<> const alone({.granularity = level + 1 == sets.size() ? Granularity::face : coarse});
        REQUIRE(sets[level][i].set.visible == alone(city.prepared, ViewCell(partition.cell(level, i))).visible);
      }
  }
}

TEST_CASE("refine: the number of threads changes neither sets nor counts", "[viewspace][law]")
{
  City const city;
  std::vector<Point3d> const sizes{{160, 160, 50}, {40, 40, 50}};
  auto const run = [&](std::size_t threads) {
    oneapi::tbb::global_control const limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
    return city.sets(sizes, Granularity::part);
  };
  auto const one = run(1), several = run(7);
  for (std::size_t level = 0; level < one.size(); ++level)
    for (std::size_t i = 0; i < one[level].size(); ++i) {
      REQUIRE(one[level][i].set.visible == several[level][i].set.visible);
      REQUIRE(one[level][i].set.statistics == several[level][i].set.statistics);
    }
}

TEST_CASE("refine: tests fewer rays than one level", "[viewspace]")
{
  City const city;
  auto const rays = [](std::vector<std::vector<CellSet>> const& sets) {
    double sum = 0;
    for (auto const& level : sets)
      for (auto const& c : level) sum += c.set.statistics.at("rays");
    return sum;
  };
  REQUIRE(rays(city.sets({{80, 80, 50}, {20, 20, 50}}, Granularity::part)) <
          rays(city.sets({{20, 20, 50}}, Granularity::part)));
}

TEST_CASE("for_each_cell: parents come first, their state reaches their children, and errors reach the caller",
          "[viewspace]")
{
  Partition const partition(Box{{0, 0, 0}, {8, 8, 8}}, std::vector<Point3d>{{4, 4, 4}, {2, 2, 2}, {1, 1, 1}});
  std::atomic<int> calls = 0;
  for_each_cell(partition, [&](std::size_t level, std::size_t, ViewCell const& cell, CellState const& parent) {
    ++calls;
    if ((level == 0) != (parent == nullptr)) throw std::logic_error("a parent's state is missing");
    if (parent) {
      auto const& outer = *static_cast<Box const*>(parent.get());
      if (!contains(outer, cell.bounds().min) || !contains(outer, cell.bounds().max))
        throw std::logic_error("the state is not that of the parent");
    }
    return std::make_shared<Box const>(cell.bounds());
  });
  REQUIRE(calls == 8 + 64 + 512);
  REQUIRE_THROWS_AS(
    for_each_cell(partition, [](auto, auto, auto const&, auto const&) -> CellState { throw std::runtime_error("no"); }),
    std::runtime_error);
  REQUIRE_THROWS_AS(refine(City().prepared, partition, std::vector<StrongOcclusion<>>(2)), std::invalid_argument);
}
