#include "ends.hpp"
#include "scenes.hpp"

#include "support/height_field_scenes.hpp"
#include "support/random.hpp"

namespace visibility::bench::exact_25d {

namespace {

std::string to_string(test::HeightScene kind)
{
  switch (kind) {
  case test::HeightScene::general: return "general";
  case test::HeightScene::grid: return "grid";
  case test::HeightScene::streets: return "streets";
  case test::HeightScene::slanted: return "slanted";
  case test::HeightScene::slanted_grid: return "slanted grid";
  case test::HeightScene::far_detail: return "grid of millimetres near 10^6";
  case test::HeightScene::one_ulp: return "streets, moved by an ulp";
  }
  return "";
}

}  // namespace

void double_arithmetic(Report& report, Size size)
{
  int const scenes = size == Size::full ? 2000 : 20;
  auto& table = report.table("Verdicts of plain double on small hard scenes of 4 to 16 objects",
                             {"family", "scenes", "of these exact", "objects", "visible", "false hidden",
                              "false visible", "scenes wrong", "endless", "us exact", "us double"});
  for (auto const kind : test::height_scenes) {
    Sums sums;
    for (int trial = 0; trial < scenes; ++trial) {
      test::Random random(static_cast<std::uint64_t>(trial) + 1);
      auto const c = test::height_case(random, kind, random.between(4, 16));
      HeightField const field(c.scene);
      auto const cell = ViewCell::hull(c.cell);
      PotentiallyVisibleSet set, plain;
      double const exact = median_seconds<ProcessorClock>(1, 0, [&] { set = Exact25d<>()(field, cell); });
      if (set.guarantee != Guarantee::exact) continue;
      sums.add("exact", 1);
      sums.add("us exact", 1e6 * exact);
      if (!ends<Double>(field, cell, 2)) {
        sums.add("failures", 1);
        continue;
      }
      sums.add("us double",
               1e6 * median_seconds<ProcessorClock>(1, 0, [&] { plain = Exact25d<Double>()(field, cell); }));
      auto const hidden = static_cast<double>(difference(set.visible, plain.visible).size());
      auto const shown = static_cast<double>(difference(plain.visible, set.visible).size());
      sums.add("objects", static_cast<double>(c.scene.objects.size()));
      sums.add("visible", static_cast<double>(set.visible.size()));
      sums.add("hidden", hidden);
      sums.add("shown", shown);
      sums.add("wrong", hidden + shown > 0 ? 1 : 0);
    }
    double const n = std::max(1.0, sums["exact"]);
    table.add({to_string(kind), double(scenes), sums["exact"], sums["objects"], sums["visible"], sums["hidden"],
               sums["shown"], sums["wrong"], sums["failures"], sums["us exact"] / n, sums["us double"] / n});
  }
  table.notes = {"Recipes: tests/support/height_field_scenes.hpp, seeds 1, 2, ... Left out: scenes whose columns reach",
                 "into the cell. Endless: no answer within 2 s; their objects are not counted."};
}

}  // namespace visibility::bench::exact_25d
