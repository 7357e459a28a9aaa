#include "experiments.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/viewspace/refine.hpp"

#include <oneapi/tbb/global_control.h>

namespace visibility::bench::strong_occlusion {

namespace {

using visibility::strong_occlusion::Granularity;

struct Cost {
  double box_rays = 0, face_rays = 0, probes = 0, visible = 0, seconds = 0;
};

/// What all cells of all levels cost together; `visible` is the average of the finest.
Cost cost_of(PreparedScene const& scene, std::vector<double> const& sides, Options options, Granularity coarse)
{
  Box const viewspace{{-200, -200, 0}, {200, 200, 50}};
  std::vector<Point3d> sizes;
  for (double const s : sides) sizes.push_back({s, s, 50});
  std::vector<StrongOcclusion<>> methods(sides.size(), StrongOcclusion<>(options));
  options.granularity = coarse;
  std::fill(methods.begin(), methods.end() - 1, StrongOcclusion<>(options));
  Cost cost;
  auto const all = refine(scene, Partition(viewspace, sizes), methods);
  for (auto const& level : all)
    for (auto const& cell : level) {
      auto const& s = cell.set.statistics;
      cost.box_rays += s.at("rays") - s.at("face_rays");
      cost.face_rays += s.at("face_rays");
      cost.probes += s.at("probes");
      cost.seconds += cell.seconds;
    }
  for (auto const& cell : all.back()) cost.visible += double(cell.set.visible.size()) / double(all.back().size());
  return cost;
}

}  // namespace

void levels(Report& report, Size size)
{
  oneapi::tbb::global_control const one_core(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  Scene const scene = generate(city(size));
  PreparedScene const prepared(scene);
  auto& table =
    report.table("Table 4: cells of 20 over the viewspace of 400 x 400, from the scene or from coarser cells",
                 {"optimizations", "levels", "coarse", "visible", "ray/box", "ray/polygon", "boxes probed", "seconds",
                  "cost ratio"});
  table.add({"paper", "20", Value(), Value(), 85.2e6, 22.2e6, Value(), 400 * 15.0, 1.0});
  table.add({"paper", "80, 20", Value(), Value(), 29.0e6, 27.1e6, Value(), 400 * 5.0 + 25 * 26.0, 85.2 / 29.0});
  Options published_and_groups = as_published();
  published_and_groups.groups = true;
  for (auto const& [name, options] : {std::pair("as published", as_published()),
                                      std::pair("and groups", published_and_groups), std::pair("all", Options{})}) {
    Cost const one = cost_of(prepared, {20}, options, Granularity::face);
    auto const add = [&](std::string const& sides, std::string const& coarse, Cost const& c) {
      table.add(
        {name, sides, coarse, c.visible, c.box_rays, c.face_rays, c.probes, c.seconds, one.box_rays / c.box_rays});
    };
    add("20", "", one);
    for (auto const coarse : {Granularity::object, Granularity::part, Granularity::face})
      add("80, 20", to_string(coarse), cost_of(prepared, {80, 20}, options, coarse));
    if (size == Size::full) {
      add("40, 20", "part", cost_of(prepared, {40, 20}, options, Granularity::part));
      add("80, 40, 20", "part", cost_of(prepared, {80, 40, 20}, options, Granularity::part));
    }
  }
  table.notes = {"Cost ratio: ray/box tests of one level over these, all levels included, as the paper compares.",
                 "Polygon tests are those the method makes: it stops at the first visible polygon of an object."};
}

}  // namespace visibility::bench::strong_occlusion
