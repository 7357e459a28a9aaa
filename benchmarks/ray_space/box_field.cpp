#include "experiments.hpp"

namespace visibility::bench::ray_space {

namespace {

std::string specification(Size size)
{
  return size == Size::full ? "box-field,n=1725000,density=3,clear=10" : "box-field,n=200";
}

/// Half way up the field: its boxes keep clear of the ground, so that from there one sees far below them.
ViewCell cell_in_field(double x, double side)
{
  return ViewCell(Box{{x - side / 2, -side / 2, 20}, {x + side / 2, side / 2, 30}});
}

/// Beside the field, as far away as its half side again.
double far_off(Scene const& scene) { return 2 * bounding_box(scene).max.x; }

}  // namespace

void box_field(Report& report, Size size)
{
  struct Published {
    double side, near_seconds, near_pvs, near_vs, far_seconds, far_pvs, far_vs;
  };
  std::vector<Published> const table_2{{5, 0.93, 4864, 1312, 3.22, 35456, 14224},
                                       {10, 1.10, 6032, 1424, 3.45, 37072, 14256},
                                       {15, 1.27, 7184, 1552, 3.59, 38912, 14304},
                                       {20, 1.39, 8176, 1632, 3.71, 40080, 14416},
                                       {30, 1.87, 13136, 2400, 4.04, 43248, 14672}};
  auto& table =
    report.table("Table 2: box field (paper | ours)",
                 {"place", "cell side, m", "paper: PVS, triangles", "paper: PVS / VS", "paper, s", "PVS, objects",
                  "VS, objects", "PVS / VS", "ours, s", "8 umbrae: PVS", "s", "8 umbrae, 2048: PVS", "s"});
  Model const model(specification(size), true);
  for (bool const near : {true, false})
    for (auto const& r : table_2) {
      ViewCell const cell = cell_in_field(near ? 0 : far_off(model.scene), r.side);
      auto const m = measure_once(*model.prepared, cell, {.resolution = 512, .coarse = 512, .components = 2});
      auto const more = measure_once(*model.prepared, cell, {.resolution = 512, .coarse = 512, .components = 8});
      auto const finer = measure_once(*model.prepared, cell, {.resolution = 2048, .coarse = 256, .components = 8});
      double const vs = sampled(model, cell, size);
      table.add({near ? "near" : "far", r.side, near ? r.near_pvs : r.far_pvs,
                 near ? r.near_pvs / r.near_vs : r.far_pvs / r.far_vs, near ? r.near_seconds : r.far_seconds, m.objects,
                 vs, m.objects / vs, m.seconds, more.objects, more.seconds, finer.objects, finer.seconds});
      if (size == Size::smoke) break;
    }
  table.notes = {"Two components and whole pixels at 512 unless said; at 2048 from pixels of 256 on. One run each. VS: "
                 "guided sampling, 3 * 10^6 rays, a lower bound.",
                 std::to_string(model.scene.triangles.size()) + " triangles; hierarchy and bodies built in " +
                   std::to_string(model.build_seconds) + " s."};
}

void components(Report& report, Size size)
{
  auto& table = report.table("Umbrae kept for each direction, cell of 20 x 20 x 10 in the box field",
                             {"density", "boxes", "components", "objects", "s"});
  for (auto const* density : {"0.2", "0.5"}) {
    Model const model(std::string("box-field,density=") + density + (size == Size::full ? ",n=20000" : ",n=200"),
                      false);
    for (int const k : {1, 2, 4, 8, 16}) {
      auto const m =
        measure(*model.prepared, cell_at(0, 0, 20, 10), {.resolution = 512, .coarse = 512, .components = k}, false);
      table.add(
        {std::string(density), static_cast<double>(model.scene.objects.size()), double(k), m.objects, m.seconds});
    }
    if (size == Size::smoke) break;
  }
}

}  // namespace visibility::bench::ray_space
