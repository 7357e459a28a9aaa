#include "experiments.hpp"

#include "scenes.hpp"

#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/methods/strong_occlusion/method.hpp"

#include <algorithm>
#include <stdexcept>

namespace visibility::bench::extended_projection {

namespace {

using Options = visibility::extended_projection::Options;

std::string district(int copies) { return "gen:district,copies=" + std::to_string(copies); }

Options with_resolution(int resolution)
{
  Options o;
  o.resolution = resolution;
  return o;
}

}  // namespace

void resolution(Report& report, Size size)
{
  bool const full = size == Size::full;
  Model const m(district(full ? 4 : 1).substr(4), true);
  auto const cells = street_cells(full ? 28 : 2);
  auto& table =
    report.table("Figure 12: resolution, " + m.name + ", street cells",
                 {"resolution", "projection, ms", "polygons hidden, %", "sweep, ms", "polygons hidden, % "});
  for (int n = full ? 64 : 128; n <= (full ? 1024 : 128); n *= 2) {
    auto const p = measure(m, cells, ExtendedProjection(with_resolution(n)));
    auto const s = measure(m, cells, OcclusionSweep(with_resolution(n)));
    table.add({double(n), 1e3 * p.seconds, p.hidden_polygons_percent, 1e3 * s.seconds, s.hidden_polygons_percent});
  }
  table.notes.emplace_back("The paper: 600,000 polygons; best time at 256, where culling stops to improve.");
}

void growth(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table("Figure 13: growth with the scene, street cells",
                             {"polygons", "projection, ms", "sweep, ms", "visible, sweep"});
  std::vector<std::pair<double, double>> projection, sweep;
  std::vector<int> const copies = full ? std::vector{1, 2, 4, 8, 12} : std::vector{1, 2};
  for (int const c : copies) {
    Model const m(district(c).substr(4), true);
    auto const cells = street_cells(full ? 28 : 2);
    auto const p = measure(m, cells, ExtendedProjection());
    auto const s = measure(m, cells, OcclusionSweep());
    double const n = static_cast<double>(m.scene.primitive_count());
    projection.emplace_back(n, p.seconds);
    sweep.emplace_back(n, s.seconds);
    table.add({n, 1e3 * p.seconds, 1e3 * s.seconds, s.visible});
  }
  table.notes.push_back("Exponents: projection " + std::to_string(fitted_exponent(projection)) + ", sweep " +
                        std::to_string(fitted_exponent(sweep)) + "; the paper 0.5.");
}

void improved(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table("The improved Projection (repaired), visible objects",
                             {"scene", "projection", "without", "gain, %", "sweep", "without ", "gain, % "});
  auto const add = [&](Model const& m, std::vector<ViewCell> const& cells) {
    Options plain;
    plain.improved = false;
    double const p = measure(m, cells, ExtendedProjection()).visible,
                 q = measure(m, cells, ExtendedProjection(plain)).visible,
                 s = measure(m, cells, OcclusionSweep()).visible, t = measure(m, cells, OcclusionSweep(plain)).visible;
    table.add({m.name, p, q, 100 * (1 - p / q), s, t, 100 * (1 - s / t)});
  };
  add(Model(district(full ? 4 : 1).substr(4), true), street_cells(full ? 28 : 2));
  add(Model(full ? "city,n=20000" : "city,n=300", false), {ViewCell(Box{{-20, -20, 0}, {20, 20, 3}})});
  table.notes.emplace_back("The paper: 5 to 10 % smaller, with an improved Projection that hides visible objects.");
}

void lim(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table =
    report.table("Section 7.4: planes at infinity, as Lim projects, against planes behind occluders",
                 {"scene", "planes, visible", "ms", "infinity, visible", "ms ", "with improved Projection"});
  auto const add = [&](Model const& m, std::vector<ViewCell> const& cells) {
    Options plain;
    plain.improved = false;
    auto const planes = measure(m, cells, ExtendedProjection(plain));
    plain.infinity = true;
    auto const infinity = measure(m, cells, ExtendedProjection(plain));
    plain.improved = true;
    table.add({m.name, planes.visible, 1e3 * planes.seconds, infinity.visible, 1e3 * infinity.seconds,
               measure(m, cells, ExtendedProjection(plain)).visible});
  };
  add(Model(district(full ? 4 : 1).substr(4), true), street_cells(full ? 28 : 2));
  add(Model(full ? "city,n=20000" : "city,n=300", false), {ViewCell(Box{{-20, -20, 0}, {20, 20, 3}})});
}

void reprojection(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table("Section 5.1: reprojection by windows and by convolution",
                             {"scene", "resolution", "windows, visible", "ms", "convolution, visible", "ms "});
  auto const add = [&](Model const& m, std::vector<ViewCell> const& cells, int resolution) {
    Options o = with_resolution(resolution);
    auto const windows = measure(m, cells, OcclusionSweep(o));
    o.reprojection = visibility::extended_projection::Reprojection::convolution;
    auto const convolution = measure(m, cells, OcclusionSweep(o));
    table.add({m.name, double(resolution), windows.visible, 1e3 * windows.seconds, convolution.visible,
               1e3 * convolution.seconds});
  };
  Model const town(district(full ? 4 : 1).substr(4), true);
  for (int n = full ? 128 : 64; n <= (full ? 512 : 64); n *= 2) add(town, street_cells(full ? 28 : 2), n);
  add(Model(full ? "forest,n=1000,leaf=0.6" : "forest,n=30,leaf=0.6", false), crown_cells(full ? 5 : 1, 0.1),
      full ? 512 : 64);
}

void city(Report& report, Size size)
{
  bool const full = size == Size::full;
  Model const m(district(full ? 12 : 1).substr(4), true);
  auto const cells = street_cells(full ? 28 : 2);
  auto& table = report.table("Section 7.1: " + m.name + ", street cells",
                             {"method", "visible", "objects hidden, %", "polygons hidden, %", "ms", "planes",
                              "occluders", "pixels", "ns a pixel"});
  auto const add = [&](std::string const& name, Means const& s) {
    table.add({name, s.visible, s.hidden_percent, s.hidden_polygons_percent, 1e3 * s.seconds, s.planes, s.occluders,
               s.pixels, 1e9 * s.seconds / std::max(s.pixels, 1.0)});
  };
  add("extended-projection", measure(m, cells, ExtendedProjection()));
  add("occlusion-sweep", measure(m, cells, OcclusionSweep()));
  if (full) add("occlusion-sweep, resolution 384", measure(m, cells, OcclusionSweep(with_resolution(384))));
  add("occlusion-sweep, on the ground", measure(m, street_cells(full ? 28 : 2, 0), OcclusionSweep()));
  auto const few = street_cells(full ? 6 : 1);
  add("occlusion-sweep, first cells", measure(m, few, OcclusionSweep()));
  add("strong-occlusion, first cells", measure(m, few, StrongOcclusion<>()));
  table.notes.emplace_back(
    "The paper: 0.81 s a cell, 96 % hidden; strong occlusion 4 times the objects, 150 times the time.");
  table.notes.emplace_back("ns a pixel: all of the time, over pixels written.");
}

namespace {

/// A row of a table of directions: both methods with planes along the axes and along the cells.
template <class Table>
void add_directions(Table& table, Model const& m, std::vector<ViewCell> const& cells, double degrees, double length)
{
  Options axes, along;
  axes.directions = visibility::extended_projection::Directions::axes;
  along.directions = visibility::extended_projection::Directions::cell;
  auto const p = measure(m, cells, ExtendedProjection(axes)), q = measure(m, cells, ExtendedProjection(along));
  auto const s = measure(m, cells, OcclusionSweep(axes)), t = measure(m, cells, OcclusionSweep(along));
  table.add({degrees, length, p.visible, 1e3 * p.seconds, q.visible, 1e3 * q.seconds, s.visible, 1e3 * s.seconds,
             t.visible, 1e3 * t.seconds});
}

std::vector<std::string> const direction_columns{"degrees",          "length, m", "projection, axes", "ms",
                                                 "projection, cell", "ms ",       "sweep, axes",      "ms  ",
                                                 "sweep, cell",      "ms   "};

}  // namespace

void oriented(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table(
    "Section 2.4: planes along the axes and along street cells, a district and its cells turned", direction_columns);
  for (int const degrees : full ? std::vector{0, 10, 30, 45} : std::vector{30}) {
    Model const m((full ? "district,copies=4,rotation=" : "district,rotation=") + std::to_string(degrees), true);
    for (double const length : {4.0, 40.0})
      add_directions(table, m, turned_street_cells(full ? 8 : 1, length, degrees), degrees, length);
  }
  table.notes.push_back("Visible objects of " + std::to_string(full ? 400 : 100) + ".");
}

void tilted(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table(
    "Section 2.4: planes along the axes and along cells that rise along their street, a district", direction_columns);
  Model const m(full ? "district,copies=4" : "district", true);
  for (int const degrees : full ? std::vector{2, 10, 30} : std::vector{10})
    for (double const length : {4.0, 40.0})
      add_directions(table, m, tilted_street_cells(full ? 8 : 1, length, degrees), degrees, length);
  table.notes.push_back("Visible objects of " + std::to_string(full ? 400 : 100) + ".");
}

void forest(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table(
    "Section 7.2: forest, cells among the crowns, occlusion sweep",
    {"scene", "cell, m", "resolution", "visible", "objects hidden, %", "ms", "planes", "leaves projected"});
  std::vector<std::string> const scenes =
    full ? std::vector<std::string>{"forest,n=7750,leaf=0.6", "forest,n=2000,leaf=0.3"}
         : std::vector<std::string>{"forest,n=30,leaf=0.6"};
  for (auto const& name : scenes) {
    Model const m(name, false);
    for (double const side : {0.1, 0.25, 0.5}) {
      auto const cells = crown_cells(full ? 5 : 1, side);
      for (int const n : {256, 512}) {
        auto const s = measure(m, cells, OcclusionSweep(with_resolution(n)));
        table.add({m.name, side, double(n), s.visible, s.hidden_percent, 1e3 * s.seconds, s.planes, s.occluders});
      }
      if (!full) break;
    }
  }
  table.notes.emplace_back(
    "The paper: 7.8 M triangles, 15 planes, 23 s a cell, 95.5 % hidden; neither its leaves nor its cells are given.");
}

void truth(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table("What guided rays see: no conservative method hides more",
                             {"scene", "cells", "rays a cell", "seen", "hidden at most, %"});
  auto const add = [&](Model const& m, std::string const& where, std::vector<ViewCell> const& cells, double rays) {
    double const seen = mean_seen(m, cells, static_cast<std::uint64_t>(full ? rays : rays / 100));
    table.add({m.name, where, rays, seen, 100 * (1 - seen / static_cast<double>(m.scene.objects.size()))});
  };
  {
    Model const town(district(full ? 12 : 1).substr(4), false);
    if (full) add(town, "28 street cells", street_cells(28), 1e6);
    for (double const rays : {1e6, 1e7}) add(town, "the first two of them", street_cells(2), rays);
  }
  Model const trees(full ? "forest,n=7750,leaf=0.6" : "forest,n=30,leaf=0.6", false);
  for (double const side : {0.1, 0.25, 0.5})
    add(trees, "among the crowns, " + std::to_string(side) + " m", crown_cells(full ? 5 : 1, side), 1e6);
}

void error(Report& report, Size size)
{
  bool const full = size == Size::full;
  Model const m(full ? "city,n=20000" : "city,n=300", false);
  HeightField const field(m.scene);
  std::vector<ViewCell> cells;
  for (int i = 0; i < (full ? 9 : 1); ++i) {
    double const x = -200 + 150 * (i % 3), y = -200 + 150 * (i / 3);
    cells.emplace_back(Box{{x, y, 0}, {x + 20, y + 20, 3}});
  }
  double exact = 0, exact_seconds = 0;
  std::vector<std::vector<std::uint32_t>> sets;
  for (auto const& cell : cells) {
    exact_seconds += median_seconds<ProcessorClock>(1, 0, [&] { sets.push_back(Exact25d<>()(field, cell).visible); });
    exact += static_cast<double>(sets.back().size());
  }
  double const n = static_cast<double>(cells.size());
  auto& table = report.table("Overestimation |P| / |E| over resolution, " + m.name,
                             {"resolution", "projection", "ms", "sweep", "ms "});
  for (int r = full ? 32 : 128; r <= (full ? 1024 : 128); r *= 2) {
    auto const p = measure(m, cells, ExtendedProjection(with_resolution(r)));
    auto const s = measure(m, cells, OcclusionSweep(with_resolution(r)));
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (!std::ranges::includes(OcclusionSweep(with_resolution(r))(*m.prepared, cells[i]).visible, sets[i]))
        throw std::runtime_error("a visible object is missing");
    table.add({double(r), p.visible * n / exact, 1e3 * p.seconds, s.visible * n / exact, 1e3 * s.seconds});
  }
  auto const strong = measure(m, cells, StrongOcclusion<>());
  table.notes.push_back("exact-2.5d: " + std::to_string(exact / n) + " objects in " +
                        std::to_string(1e3 * exact_seconds / n) +
                        " ms; strong-occlusion: " + std::to_string(strong.visible * n / exact) + " in " +
                        std::to_string(1e3 * strong.seconds) + " ms");
}

}  // namespace visibility::bench::extended_projection
