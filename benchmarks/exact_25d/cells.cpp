#include "ends.hpp"
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
  std::size_t cells = 0, differing = 0, endless = 0;
  double visible = 0, least = HUGE_VAL, most = 0, edges = 0, exact = 0, both = 0, rounded = 0;
};

/// Means over the cells; seconds are medians of a cell; the ratio is of sums, measured in turn.
Row measure(HeightField const& field, std::vector<ViewCell> const& cells, int runs)
{
  Row row;
  for (auto const& cell : cells) {
    PotentiallyVisibleSet set;
    double const exact = median_seconds<ProcessorClock>(runs, 0.1, [&] { set = exact_set(field, cell); });
    if (ends<Double>(field, cell, 2 + static_cast<unsigned>(10 * exact))) {
      PotentiallyVisibleSet plain;
      auto const [of_exact, of_double] = medians_in_turn<ProcessorClock>(
        exact < 0.1 ? runs : 1, [&] { Exact25d<>()(field, cell); }, [&] { plain = Exact25d<Double>()(field, cell); });
      row.both += of_exact;
      row.rounded += of_double;
      row.differing += difference(set.visible, plain.visible).size() + difference(plain.visible, set.visible).size();
    } else {
      ++row.endless;
    }
    double const n = static_cast<double>(cells.size()), visible = static_cast<double>(set.visible.size());
    ++row.cells;
    row.visible += visible / n;
    row.least = std::min(row.least, visible);
    row.most = std::max(row.most, visible);
    row.edges += set.statistics.at("occluders_inserted") / n;
    row.exact += exact / n;
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
                  "edges inserted", "paper, s", "exact, ms", "exact / Double", "Double wrong", "Double endless"});
  auto const add = [&](std::string const& name, double perimeter, double height, Published const* p, Row const& r) {
    if (r.cells == 0) {
      table.notes.push_back(name + ": no free place for a perimeter of " + std::to_string(int(perimeter)) + " m");
      return;
    }
    table.add({name, perimeter, height, double(r.cells), p != nullptr ? Value(p->visible) : Value(), r.visible, r.least,
               r.most, r.edges, p != nullptr ? Value(p->seconds) : Value(), 1e3 * r.exact,
               r.rounded > 0 ? Value(r.both / r.rounded) : Value(), double(r.differing), double(r.endless)});
  };
  for_each_model(size, table.notes, [&](Source const& source, Model const& m) {
    for (auto const& p : published)
      if (p.scene == source.counterpart)
        add(to_string(p.scene) + ": " + m.name, p.perimeter, p.height, &p,
            measure(*m.field,
                    answered_cells(m, {p.perimeter, p.height, street_width(p.scene)}, full ? 3 : 2, table.notes),
                    full ? 3 : 1));
    if (source.counterpart != Paper::city) return;
    // From above the roofs much of the city is seen: the square without buildings in the middle, and higher up.
    double const high = full ? 850 : 2, highest = full ? 865 : 2;
    for (auto const& [half, top] : {std::pair(71.0, 2.0), std::pair(2.0, high), std::pair(71.0, highest)}) {
      ViewCell const cell(Box{{-half, -half, 0}, {half, half, top}});
      add(to_string(source.counterpart) + ": central square", 8 * half, top, nullptr, measure(*m.field, {cell}, 1));
    }
  });
  table.notes.insert(
    table.notes.begin(),
    {"The paper counts boxes of buildings in Vienna, top edges elsewhere; ours are objects (buildings).",
     "Edges inserted: into leaves of the occlusion tree, an edge in several leaves several times.",
     "Double: objects on which it errs, over all cells, and cells where it never ends. Paper: 2 GHz Opteron."});
}

}  // namespace visibility::bench::exact_25d
