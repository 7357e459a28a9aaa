#include "experiments.hpp"

#include "visibility/methods/strong_occlusion/survey.hpp"
#include "visibility/scene/generators.hpp"

#include <map>

namespace visibility::bench::strong_occlusion {

namespace {

using visibility::strong_occlusion::BoxTarget;
using visibility::strong_occlusion::Counts;
using visibility::strong_occlusion::Shaft;

using Histogram = std::array<double, 11>;

std::map<double, Histogram> const published{{200, {0, 0, 1, 0, 0, 0, 1, 2, 1, 2, 5}},
                                            {150, {0, 0, 2, 1, 1, 3, 6, 5, 3, 5, 13}},
                                            {100, {32, 30, 46, 51, 51, 44, 29, 23, 15, 6, 10}},
                                            {70, {829, 571, 359, 284, 184, 103, 78, 37, 22, 14, 40}},
                                            {50, {1470, 635, 377, 185, 111, 68, 32, 15, 11, 1, 13}},
                                            {30, {2045, 630, 231, 86, 32, 10, 7, 4, 4, 2, 1}},
                                            {20, {2345, 504, 160, 45, 19, 5, 5, 2, 2, 1, 0}}};

/// The rank, by distance from the cell, of the nearest strong occluder among the boxes that some sight line meets;
/// 0: there is none.
std::size_t rank_of_strong_occluder(PreparedScene const& scene, ViewCell const& cell, Box const& box, Shaft& shaft)
{
  BoxTarget const target(box);
  shaft.aim(target.target());
  std::vector<std::pair<double, std::uint32_t>> met;
  for (auto const& r : shaft.rays())
    scene.body_hierarchy().any_along(SegmentProbe(r.from, r.to), [&](std::uint32_t b) {
      if (segment_meets<Filtered, End::excluded>(scene.bodies(), scene.bodies().bodies()[b], r.from, r.to))
        met.emplace_back(approximate_squared_distance(cell.bounds(), scene.bodies().bounds()[b]), b);
      return false;
    });
  std::ranges::sort(met);
  met.erase(std::unique(met.begin(), met.end()), met.end());
  Counts counts;
  for (std::size_t i = 0; i < met.size(); ++i) {
    auto const b = met[i].second;
    if (visibility::strong_occlusion::blocks_all<Filtered>(scene.occluders(), b, shaft, counts)) return i + 1;
  }
  return 0;
}

}  // namespace

void ranks(Report& report, Size size)
{
  Scene const scene = generate(city(size));
  PreparedScene const prepared(scene);
  std::vector<std::string> columns{"side"};
  for (int i = 1; i <= 10; ++i) columns.push_back(std::to_string(i));
  columns.emplace_back("> 10");
  auto& table =
    report.table("Table 3: rank of the nearest strong occluder among the potential ones (paper, then ours)", columns);
  for (auto const& [side, paper] : published) {
    if (size == Size::smoke && side > 50) continue;
    Histogram ours{};
    auto const cell = ground_cell(side);
    Shaft shaft(cell, Shaft::Rays::all, Shaft::Culling::leading_ray);
    for (auto const& box : scene.boxes) {
      if (!certainly_disjoint(cell, box)) continue;
      auto const rank = rank_of_strong_occluder(prepared, cell, box, shaft);
      if (rank > 0) ++ours[std::min<std::size_t>(rank, 11) - 1];
    }
    for (Histogram const* counts : {&paper, static_cast<Histogram const*>(&ours)}) {
      std::vector<Value> row{side};
      row.insert(row.end(), counts->begin(), counts->end());
      table.add(row);
    }
  }
  table.notes = {"Potential occluders: boxes that one of the 64 sight lines meets, ordered by distance from the cell."};
}

}  // namespace visibility::bench::strong_occlusion
