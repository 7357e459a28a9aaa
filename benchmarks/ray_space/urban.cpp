#include "experiments.hpp"

#include "visibility/methods/exact_25d/method.hpp"

#include <algorithm>

namespace visibility::bench::ray_space {

namespace {

struct Row {
  double side, off_seconds, off_pvs, off_vs, in_seconds, in_pvs, in_vs;
};
std::vector<Row> const table_1{{3, 0.31, 2412, 1760, 0.40, 8832, 6824},
                               {9, 0.41, 2840, 2632, 0.51, 12184, 9072},
                               {14, 0.58, 3592, 2894, 0.96, 13576, 9184},
                               {20, 0.71, 4568, 2928, 1.56, 18304, 9888},
                               {25, 0.78, 5224, 2960, 2.01, 21608, 10072}};

constexpr double mid_block = 55;  ///< m from the avenue's axis: between the lots in the middle of the first block

ViewCell cell_by(bool junction, double side)
{
  double const at = junction ? 0 : mid_block;
  return cell_at(at, at, side, 2.5);
}

std::string specification(Size size) { return size == Size::full ? "urban,n=120350" : "urban,n=100"; }

}  // namespace

void urban(Report& report, Size size)
{
  auto& table = report.table("Table 1: urban scene (paper | ours)",
                             {"place", "cell side, m", "paper: PVS, triangles", "paper: PVS / VS", "paper, s",
                              "ours: PVS, triangles", "PVS, objects", "VS, objects", "PVS / VS", "ours, s",
                              "at 512: PVS, objects", "at 512: PVS / VS", "at 512, s"});
  Model const model(specification(size), true);
  for (bool const junction : {false, true})
    for (auto const& r : table_1) {
      ViewCell const cell = cell_by(junction, r.side);
      auto const m = measure(*model.prepared, cell, {});
      auto const at_512 = measure(*model.prepared, cell, {.resolution = 512}, false);
      double const vs = sampled(model, cell, size);
      table.add({junction ? "in junction" : "off junction", r.side, junction ? r.in_pvs : r.off_pvs,
                 junction ? r.in_pvs / r.in_vs : r.off_pvs / r.off_vs, junction ? r.in_seconds : r.off_seconds,
                 m.triangles, m.objects, vs, m.objects / vs, m.seconds, at_512.objects, at_512.objects / vs,
                 at_512.seconds});
      if (size == Size::smoke) break;
    }
  table.notes = {
    "Objects are buildings. VS: guided sampling, 3 * 10^6 rays, a lower bound; the paper samples viewpoints.",
    std::to_string(model.scene.triangles.size()) + " triangles; hierarchy and bodies built in " +
      std::to_string(model.build_seconds) + " s."};
}

void tightness(Report& report, Size size)
{
  auto& table = report.table("Table 1 without decks, against the exact set (paper: against samples)",
                             {"place", "cell side, m", "paper: PVS / VS", "exact, objects", "missing", "resolution",
                              "PVS, objects", "PVS / exact", "ours, s"});
  Model const model(size == Size::full ? "urban,n=20000,decks=0,ledge=0" : "urban,n=100,decks=0,ledge=0", false);
  HeightField const field(model.scene);
  for (bool const junction : {false, true})
    for (auto const& r : table_1) {
      ViewCell const cell = cell_by(junction, r.side);
      auto const exact = Exact25d<>()(field, cell);
      for (int const resolution : {512, 1024, 2048, 4096, 16384}) {
        auto const ours = RaySpace({.resolution = resolution})(*model.prepared, cell).visible;
        double missing = 0;
        // Where buildings reach into the cell the other set is conservative too, and may hold what is hidden.
        if (exact.guarantee == Guarantee::exact)
          for (auto const o : exact.visible) missing += !std::ranges::binary_search(ours, o);
        auto const m = measure(*model.prepared, cell, {.resolution = resolution}, false);
        auto const all = static_cast<double>(exact.visible.size());
        table.add({junction ? "in junction" : "off junction", r.side,
                   junction ? r.in_pvs / r.in_vs : r.off_pvs / r.off_vs, all, missing, static_cast<double>(resolution),
                   m.objects, m.objects / all, m.seconds});
      }
      if (size == Size::smoke) break;
    }
  table.notes = {"Off the junction cells from 14 m on reach into buildings, and the exact set is conservative."};
}

void umbrae(Report& report, Size size)
{
  struct Published {
    double side, vs, half, half_seconds, full, full_seconds;
  };
  std::vector<Published> const table_3{{3, 7536, 28296, 0.966, 18968, 1.354},
                                       {9, 7720, 31936, 1.149, 22368, 1.704},
                                       {14, 7808, 33504, 1.184, 22576, 1.745},
                                       {25, 8304, 36480, 1.253, 24520, 1.845}};
  auto& table = report.table(
    "Table 3: half and full umbra, 30 % of the buildings on decks (paper | ours)",
    {"cell side, m", "paper: half / full", "half, objects", "full, objects", "half / full", "half, s", "full, s"});
  Model const model(size == Size::full ? "urban,n=90000" : "urban,n=100", false);
  for (auto const& r : table_3) {
    ViewCell const cell = cell_at(0, 0, r.side, 2.5);
    auto const half = measure(*model.prepared, cell, {.umbra = visibility::ray_space::Umbra::half}, false);
    auto const full = measure(*model.prepared, cell, {}, false);
    table.add(
      {r.side, r.half / r.full, half.objects, full.objects, half.objects / full.objects, half.seconds, full.seconds});
    if (size == Size::smoke) break;
  }
}

void resolution(Report& report, Size size)
{
  struct Published {
    double resolution, pvs, seconds;
  };
  std::vector<Published> const table_4{
    {128, 36936, 0.626}, {256, 27920, 1.217}, {512, 21608, 2.011}, {1024, 14168, 5.335}};
  auto& table =
    report.table("Table 4: resolution of ray space, cell of 25 in the junction (paper | ours)",
                 {"resolution", "paper: PVS, triangles", "paper, s", "ours: PVS, triangles", "objects", "ours, s"});
  Model const model(specification(size), false);
  for (auto const& r : table_4) {
    auto const m = measure(*model.prepared, cell_at(0, 0, 25, 2.5), {.resolution = static_cast<int>(r.resolution)});
    table.add({r.resolution, r.pvs, r.seconds, m.triangles, m.objects, m.seconds});
    if (size == Size::smoke) break;
  }
  table.notes = {"The paper's exact set has 10072 triangles."};
  auto& finer = report.table("Finer than the resolutions of the paper, and from what pixels on",
                             {"resolution", "coarse", "objects", "ours, s"});
  for (auto const& [resolution, coarse] :
       {std::pair(512, 512), std::pair(512, 64), std::pair(512, 128), std::pair(2048, 128), std::pair(4096, 128),
        std::pair(4096, 64), std::pair(8192, 128), std::pair(16384, 128)}) {
    auto const m = measure(*model.prepared, cell_by(true, 25), {.resolution = resolution, .coarse = coarse}, false);
    finer.add({static_cast<double>(resolution), static_cast<double>(coarse), m.objects, m.seconds});
    if (size == Size::smoke) break;
  }
}

}  // namespace visibility::bench::ray_space
