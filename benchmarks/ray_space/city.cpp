#include "experiments.hpp"

#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/read_scene.hpp"

#include <filesystem>

namespace visibility::bench::ray_space {

namespace {

Scene real_city(Size size, std::string& name)
{
  auto const path = std::filesystem::path(VISIBILITY_SCENES_DIR) / "city/tokyo_chuo.geojsonl.gz";
  if (size == Size::smoke || !std::filesystem::exists(path)) {
    name = size == Size::smoke ? "city,n=100" : "city,n=3000,base=40,street=11.6,low=12,high=25";
    return generate(name);
  }
  name = "Tokyo, Chuo";
  return read_scene(path, {});
}

}  // namespace

void city(Report& report, Size size)
{
  struct Published {
    double side, seconds, pvs, vs;
  };
  std::vector<Published> const table_5{{3, 0.18, 964, 424},   {14, 0.19, 1216, 514},  {25, 0.22, 1546, 592},
                                       {50, 0.36, 3396, 502}, {100, 0.45, 4424, 744}, {150, 0.58, 5720, 930}};
  std::string name;
  Scene const scene = real_city(size, name);
  HeightField const field(scene);
  PreparedScene const prepared(scene, InnerBodyOptions{});
  Box const all = bounding_box(scene);
  auto& table = report.table("Table 5: a real city, paper: Vienna 2000; ours: " + name + " (paper | ours)",
                             {"cell side, m", "paper: PVS / VS", "paper, s", "PVS, objects", "exact, objects",
                              "PVS / exact", "missing", "ours, s", "exact, s"});
  for (auto const& r : table_5) {
    Measured sum;
    double exact = 0, exact_seconds = 0, missing = 0;
    int const places = size == Size::full ? 3 : 1;
    for (int i = 0; i < places; ++i) {
      double const x = all.min.x + (all.max.x - all.min.x) * (0.4 + 0.1 * i), y = 0.5 * (all.min.y + all.max.y);
      ViewCell const cell(
        Box{{x - r.side / 2, y - r.side / 2, all.min.z}, {x + r.side / 2, y + r.side / 2, all.min.z + 2}});
      PotentiallyVisibleSet of_exact;
      exact_seconds += median_seconds<ProcessorClock>(1, 0, [&] { of_exact = Exact25d<>()(field, cell); }) / places;
      auto const ours = RaySpace()(prepared, cell).visible;
      // From cells in which columns reach the top the other set is conservative too, and may hold what is hidden.
      if (of_exact.guarantee == Guarantee::exact)
        for (auto const o : of_exact.visible) missing += !std::ranges::binary_search(ours, o);
      exact += static_cast<double>(of_exact.visible.size());
      auto const m = measure(prepared, cell, {}, false);
      sum.objects += m.objects;
      sum.seconds += m.seconds / places;
    }
    table.add({r.side, r.pvs / r.vs, r.seconds, sum.objects / places, exact / places, sum.objects / exact, missing,
               sum.seconds, exact_seconds});
    if (size == Size::smoke) break;
  }
  table.notes = {
    "Means over three cells along the middle of the city. Objects are buildings; columns that stand in a cell "
    "are seen by contact; where they reach its top the exact method leaves them out as occluders, is conservative, and "
    "is "
    "not asked what is missing."};
}

void bounds(Report& report, Size size)
{
  auto& table =
    report.table("Exact and linear bounds, and granularity", {"scene", "bounds", "granularity", "objects", "s"});
  for (auto const* spec : {"urban,n=5000", "box-field,n=10000,density=0.5"}) {
    Model const model(size == Size::full ? spec : "urban,n=100", false);
    ViewCell const cell = cell_at(0, 0, 20, 2.5);
    for (auto const b : {visibility::ray_space::Bounds::exact, visibility::ray_space::Bounds::linear})
      for (auto const g : {visibility::ray_space::Granularity::object, visibility::ray_space::Granularity::part,
                           visibility::ray_space::Granularity::face}) {
        auto const m = measure(*model.prepared, cell, {.resolution = 512, .bounds = b, .granularity = g}, false);
        table.add({std::string(spec), to_string(b), to_string(g), m.objects, m.seconds});
      }
    if (size == Size::smoke) break;
  }
}

}  // namespace visibility::bench::ray_space
