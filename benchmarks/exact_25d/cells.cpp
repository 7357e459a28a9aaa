#include "scenes.hpp"

namespace visibility::bench::exact_25d {

namespace {

/// A row of table 2.
struct Published {
  Paper scene;
  double perimeter, height, visible, seconds;
};

std::vector<Published> const published{{Paper::vienna, 36, 2, 84, 0.013},    {Paper::vienna, 535, 2, 235, 0.060},
                                       {Paper::atlanta, 17, 2, 279, 0.055},  {Paper::atlanta, 44, 2, 890, 0.298},
                                       {Paper::atlanta, 89, 2, 1053, 0.488}, {Paper::atlanta, 177, 2, 1328, 0.918},
                                       {Paper::city, 13, 2, 1041, 2.263},    {Paper::city, 569, 2, 7050, 70.2},
                                       {Paper::random, 36, 2, 113, 0.156},   {Paper::random, 36, 4, 194, 0.438}};

struct Row {
  std::size_t cells = 0, differing = 0;
  double visible = 0, least = HUGE_VAL, most = 0, edges = 0, exact = 0, rounded = 0;
};

/// Means over the cells; seconds are medians of a cell, exact and Double in turn.
Row measure(HeightField const& field, std::vector<ViewCell> const& cells, int runs)
{
  Row row;
  for (auto const& cell : cells) {
    auto const set = exact_set(field, cell);
    PotentiallyVisibleSet plain;
    auto const [exact, rounded] = medians_in_turn<ProcessorClock>(
      runs, [&] { Exact25d<>()(field, cell); }, [&] { plain = Exact25d<Double>()(field, cell); });
    double const n = static_cast<double>(cells.size()), visible = static_cast<double>(set.visible.size());
    ++row.cells;
    row.differing += difference(set.visible, plain.visible).size() + difference(plain.visible, set.visible).size();
    row.visible += visible / n;
    row.least = std::min(row.least, visible);
    row.most = std::max(row.most, visible);
    row.edges += set.statistics.at("occluders_inserted") / n;
    row.exact += exact / n;
    row.rounded += rounded / n;
  }
  return row;
}

}  // namespace

void cells(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table =
    report.table("Table 2: mean set and time by size of the cell (paper | ours)",
                 {"scene", "perimeter", "height", "cells", "paper: visible", "ours: objects", "least", "most",
                  "edges inserted", "paper, s", "exact, ms", "Double, ms", "exact / Double", "differing"});
  auto const add = [&](std::string const& name, double perimeter, double height, Published const* p, Row const& r) {
    if (r.cells == 0) {
      table.notes.push_back(name + ": no free place for a perimeter of " + std::to_string(int(perimeter)) + " m");
      return;
    }
    table.add({name, perimeter, height, double(r.cells), p != nullptr ? Value(p->visible) : Value(), r.visible, r.least,
               r.most, r.edges, p != nullptr ? Value(p->seconds) : Value(), 1e3 * r.exact, 1e3 * r.rounded,
               r.exact / r.rounded, double(r.differing)});
  };
  for_each_model(size, table.notes, [&](Source const& source, Model const& m) {
    for (auto const& p : published)
      if (p.scene == source.counterpart)
        add(to_string(p.scene) + ": " + m.name, p.perimeter, p.height, &p,
            measure(*m.field, free_cells(*m.field, {p.perimeter, p.height, street_width(p.scene)}, full ? 10 : 2),
                    full ? 3 : 1));
    if (source.counterpart != Paper::city) return;
    // From above the roofs much of the city is seen: the square without buildings in the middle, and higher up.
    for (double const top : full ? std::vector{2.0, 300.0, 500.0} : std::vector{2.0}) {
      ViewCell const cell(Box{{-71, -71, 0}, {71, 71, top}});
      add(to_string(source.counterpart) + ": central square", 568, top, nullptr, measure(*m.field, {cell}, 1));
    }
  });
  table.notes.insert(
    table.notes.begin(),
    {"The paper counts boxes of buildings in Vienna, top edges elsewhere; ours are objects (buildings).",
     "Edges inserted: into leaves of the occlusion tree, an edge in several leaves several times.",
     "Differing: objects on which Double errs, over all cells. Paper: 2 GHz Opteron, 2005."});
}

}  // namespace visibility::bench::exact_25d
