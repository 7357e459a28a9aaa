#include "ends.hpp"
#include "scenes.hpp"

namespace visibility::bench::exact_25d {

void wedges(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table("Section 6.2: one penumbra wedge at a time, cells of perimeter 36",
                             {"scene", "height", "cells", "exact", "single wedges", "paper, more by %",
                              "ours, more by %", "exact, ms", "single wedges, ms", "missing"});
  Options single;
  single.occlusion = visibility::exact_25d::Occlusion::single_wedges;
  auto const m = load(full ? "gen:slanted" : "gen:slanted,n=200");
  for (auto const& [height, paper] : {std::pair(2.0, 47.0), std::pair(4.0, 76.0)}) {
    double exact = 0, loose = 0, exact_ms = 0, loose_ms = 0, missing = 0;
    auto const places = answered_cells(*m, {36, height}, full ? 20 : 2, table.notes);
    for (auto const& cell : places) {
      auto const set = exact_set(*m->field, cell);
      PotentiallyVisibleSet superset;
      auto const [e, l] = medians_in_turn<ProcessorClock>(
        full ? 3 : 1, [&] { Exact25d<>()(*m->field, cell); }, [&] { superset = Exact25d<>(single)(*m->field, cell); });
      missing += static_cast<double>(difference(set.visible, superset.visible).size());
      double const n = static_cast<double>(places.size());
      exact += static_cast<double>(set.visible.size()) / n;
      loose += static_cast<double>(superset.visible.size()) / n;
      exact_ms += 1e3 * e / n;
      loose_ms += 1e3 * l / n;
    }
    table.add({m->name, height, double(places.size()), exact, loose, paper, 100 * (loose / exact - 1), exact_ms,
               loose_ms, missing});
  }
  table.notes.emplace_back("Missing: visible objects that the simulated method loses, over all cells; should be 0.");
}

}  // namespace visibility::bench::exact_25d
