#include "ends.hpp"
#include "scenes.hpp"

#include <sys/resource.h>

namespace visibility::bench::exact_25d {

namespace {

/// A row of table 3, of the most complex set of cells of a scene.
struct Published {
  Paper scene;
  double perimeter, height, tests, decided, culls, time;
};

std::vector<Published> const published{{Paper::vienna, 535, 2, 11'293, 99.7, 8.7, 30},
                                       {Paper::atlanta, 177, 2, 51'704, 99.99, 6, 5},
                                       {Paper::city, 13, 2, 12'083'009, 99.99, 10, 7},
                                       {Paper::random, 36, 4, 26'026, 99.5, 11.6, 28}};

double peak_megabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

double percent(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

}  // namespace

void stages(Report& report, Size size)
{
  bool const full = size == Size::full;
  // First, while nothing else has been in memory.
  double const before = peak_megabytes();
  auto const big = load(big_city(size));
  auto& build = report.table("Building the big city", {"scene", "edges", "field, s", "peak before, MB", "peak, MB"});
  build.add({big->name, double(big->field->edges().size()), big->build_seconds, before, peak_megabytes()});
  build.notes = {"Peak: of the process, scene included. Run alone for a meaningful number."};

  auto& table = report.table("Table 3: what decides an edge in a leaf of line space, means per cell (paper | ours)",
                             {"scene", "perimeter", "height", "portal tests", "no portal decision, %",
                              "hidden by wedge, %", "seen by line, %", "decisions", "of these visible, %", "lines shot",
                              "blocked, %", "groups tested", "hidden, %", "time in decisions, %"});
  std::vector<std::vector<Value>> space{{"paper: Atlanta", "larger", 2.0, 2312.0, 1.54},
                                        {"paper: Atlanta", "smaller", 2.0, 565.0, 1.66}};
  for (auto const& p : published)
    table.add({"paper: " + to_string(p.scene), p.perimeter, p.height, p.tests, p.decided, Value(), Value(), Value(),
               p.culls, Value(), Value(), Value(), Value(), p.time});
  for_each_model(size, table.notes, [&](Source const& source, Model const& m) {
    std::vector<std::pair<double, double>> shapes;
    for (auto const& p : published)
      if (p.scene == source.counterpart) shapes.emplace_back(p.perimeter, p.height);
    if (source.counterpart == Paper::atlanta) shapes.emplace_back(17, 2);
    for (auto const& [perimeter, height] : shapes) {
      Sums sums;
      double decision_seconds = 0, seconds = 0;
      Options options;
      options.decision_seconds = &decision_seconds;
      Exact25d<> const timed(options);
      for (auto const& cell :
           answered_cells(m, {perimeter, height, street_width(source.counterpart)}, full ? 6 : 2, table.notes)) {
        sums.add(exact_set(*m.field, cell));
        seconds += median_seconds<ProcessorClock>(1, 0, [&] { timed(*m.field, cell); });
      }
      if (sums["runs"] == 0) continue;
      double const tests = sums["portal_tests"], decisions = sums["decisions"];
      table.add({m.name, perimeter, height, sums.mean("portal_tests"), percent(tests - decisions, tests),
                 percent(sums["wedge_hidden"], tests), percent(sums["sampled_visible"], tests), sums.mean("decisions"),
                 percent(sums["decided_visible"], decisions), sums.mean("shots"),
                 percent(sums["shots_blocked"], sums["shots"]), sums.mean("nodes_tested"),
                 percent(sums["nodes_hidden"], sums["nodes_tested"]), percent(decision_seconds, seconds)});
      space.push_back({m.name, perimeter, height, sums.mean("line_space_cells"), sums.mean("occluders_per_cell")});
    }
  });
  auto& leaves = report.table("Section 6.1: line space, means per cell",
                              {"scene", "perimeter", "height", "line-space cells", "occluders per cell"});
  leaves.rows = std::move(space);
}

}  // namespace visibility::bench::exact_25d
