#include "ends.hpp"
#include "scenes.hpp"

namespace visibility::bench::exact_25d {

namespace {

/// Cells of growing size: wider and longer; of Random, where only small ones fit, higher.
std::vector<CellShape> shapes(Paper p)
{
  std::vector<CellShape> out;
  for (double const x : {1, 2, 4, 8, 16, 32})
    out.push_back(p == Paper::random ? CellShape{24, 1 + std::log2(x)} : CellShape{8 * x, 2, street_width(p)});
  return out;
}

/// Work against what is visible, over cells of many sizes: figure 6.
void against_visible(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table("Figure 6: exponents e of work ~ visible^e, over cells of growing size",
                             {"scene", "cells", "visible objects, from", "to", "line-space cells", "portal tests",
                              "edges inserted", "ms", "line-space cells of edges", "portal tests of edges"});
  for_each_model(size, table.notes, [&](Source const& source, Model const& m) {
    std::vector<std::pair<double, double>> leaves, tests, edges, seconds, leaves_of_edges, tests_of_edges;
    double least = HUGE_VAL, most = 0;
    for (auto const& shape : shapes(source.counterpart))
      for (auto const& cell : answered_cells(m, shape, full ? 2 : 1, table.notes)) {
        PotentiallyVisibleSet set;
        double const s = median_seconds<ProcessorClock>(1, 0, [&] { set = exact_set(*m.field, cell); });
        double const n = static_cast<double>(set.visible.size());
        if (n < 1) continue;
        auto const& counts = set.statistics;
        double const k = std::max(1.0, counts.at("occluders_inserted"));
        double const cells = counts.at("line_space_cells"), portal = std::max(1.0, counts.at("portal_tests"));
        leaves.emplace_back(n, cells);
        tests.emplace_back(n, portal);
        edges.emplace_back(n, k);
        seconds.emplace_back(n, s);
        leaves_of_edges.emplace_back(k, cells);
        tests_of_edges.emplace_back(k, portal);
        least = std::min(least, n);
        most = std::max(most, n);
      }
    if (leaves.size() < 2 || least == most) return;
    table.add({m.name, double(leaves.size()), least, most, fitted_exponent(leaves), fitted_exponent(tests),
               fitted_exponent(edges), fitted_exponent(seconds), fitted_exponent(leaves_of_edges),
               fitted_exponent(tests_of_edges)});
  });
  table.notes.emplace_back("The paper's bounds: between k log k + log k log n and k^2 log n; its City grows faster.");
  table.notes.emplace_back(
    "Cells: perimeters 8 to 256 m, 2 m high; of Random 24 m, 1 to 6 m high. Least squares of logarithms.");
}

struct Growing {
  char const* name;
  std::vector<std::string> specifications;
  Box cell;
};

/// Time against the size of a scene of which about the same is visible.
void against_scene(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table =
    report.table("Time against the size of the scene, one cell of which about the same is visible",
                 {"scene", "edges", "build, s", "visible", "groups tested", "portal tests", "query, ms", "exponent"});
  std::vector<Growing> const families{
    {"city: open ground",
     full ? std::vector<std::string>{"gen:city,n=1880", "gen:city,n=18780", "gen:city,n=187750"}
          : std::vector<std::string>{"gen:city,n=100", "gen:city,n=300"},
     Box{{120, 120, 0}, {140, 140, 2}}},
    {"slanted",
     full ? std::vector<std::string>{"gen:slanted,n=2500", "gen:slanted,n=25000", "gen:slanted,n=250000"}
          : std::vector<std::string>{"gen:slanted,n=100", "gen:slanted,n=300"},
     Box{{-4.5, -4.5, 0}, {4.5, 4.5, 2}}}};
  for (auto const& family : families) {
    std::vector<std::pair<double, double>> points;
    for (auto const& specification : family.specifications) {
      auto const m = load(specification);
      ViewCell const cell(family.cell);
      auto const set = exact_set(*m->field, cell);
      double const seconds = median_seconds<ProcessorClock>(full ? 15 : 1, 5, [&] { Exact25d<>()(*m->field, cell); });
      points.emplace_back(double(m->field->edges().size()), seconds);
      bool const last = specification == family.specifications.back();
      table.add({family.name, points.back().first, m->build_seconds, double(set.visible.size()),
                 set.statistics.at("nodes_tested"), set.statistics.at("portal_tests"), 1e3 * seconds,
                 last ? Value(fitted_exponent(points)) : Value()});
    }
  }
}

}  // namespace

void growth(Report& report, Size size)
{
  against_visible(report, size);
  against_scene(report, size);
}

}  // namespace visibility::bench::exact_25d
