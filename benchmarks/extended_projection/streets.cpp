#include "experiments.hpp"

#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/moving_objects.hpp"
#include "visibility/viewspace/preprocess.hpp"
#include "visibility/viewspace/sets_file.hpp"

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <string>

namespace visibility::bench::extended_projection {

namespace {

/// The streets of `district,copies=12`: their middles are `pitch` apart, and the copy about the origin is surrounded.
constexpr double pitch = 124, half_street = 7;
constexpr int columns_from = -5, columns_to = 3, rows_from = -3, rows_to = 3;  // streets, in pitches

/// The paper's cars, and how high they reach.
constexpr std::uint64_t cars = 3000, car_polygons = 1400;
constexpr double car_height = 2;

/// Streets between crossings are cut into so many regions.
constexpr int regions_per_street = 4;

/// The regions of the streets of the whole city, with the cars spread evenly over them.
std::vector<MovingObject> street_regions()
{
  std::vector<MovingObject> out;
  auto const add = [&](double x0, double y0, double x1, double y1) {
    out.push_back({"street " + std::to_string(out.size() + 1), {{x0, y0, 0}, {x1, y1, car_height}}});
  };
  constexpr double part = (pitch - 2 * half_street) / regions_per_street;
  for (int i = columns_from; i <= columns_to; ++i)
    for (int j = rows_from; j <= rows_to; ++j) {
      double const x = i * pitch, y = j * pitch;
      add(x - half_street, y - half_street, x + half_street, y + half_street);
      for (int k = 0; k < regions_per_street; ++k) {
        double const from = half_street + k * part, to = from + part;
        if (i < columns_to) add(x + from, y - half_street, x + to, y + half_street);
        if (j < rows_to) add(x - half_street, y + from, x + half_street, y + to);
      }
    }
  for (std::uint64_t i = 0; i < out.size(); ++i)
    out[i].polygons = car_polygons * ((i + 1) * cars / out.size() - i * cars / out.size());
  return out;
}

/// The streets of the district about the origin, without their crossings: cells 10 m wide, 4 m long, from 0.5 m to 2 m
/// above the ground, where drivers have their eyes.
std::vector<ViewCell> initial_cells(std::size_t every)
{
  constexpr double half_width = 5, length = 4;
  std::vector<ViewCell> all, out;
  for (double const middle : {0.0, pitch})
    for (double at = half_street - pitch; at < pitch - half_street; at += length) {
      if (at > -half_street - length && at < half_street) continue;  // the crossing of both
      all.emplace_back(Box{{middle - half_width, at, 0.5}, {middle + half_width, at + length, 2}});
      all.emplace_back(Box{{at, middle - half_width, 0.5}, {at + length, middle + half_width, 2}});
    }
  for (std::size_t i = 0; i < all.size(); i += every) out.push_back(all[i]);
  return out;
}

double percent_hidden(double visible, double all) { return 100 * (1 - visible / all); }

}  // namespace

void streets(Report& report, Size size)
{
  bool const full = size == Size::full;
  Scene const houses = generate(full ? "district,copies=12" : "district");
  auto const moving = street_regions();
  Scene const scene = with_moving_objects(houses, moving);
  auto const polygons = polygon_counts(scene, moving);
  PreparedScene const prepared(scene, InnerBodyOptions{});
  std::size_t const every = full ? 4 : 60;
  auto const initial = initial_cells(every);
  double all_buildings = 0, all_cars = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    (scene.objects[i].occludes ? all_buildings : all_cars) += static_cast<double>(polygons[i]);

  auto& table =
    report.table("Section 7.1: streets of a district in " + houses.source + ", " + std::to_string(moving.size()) +
                   " street regions with 3,000 cars; every " + std::to_string(every) + "th initial cell",
                 {"method", "budget", "initial cells", "leaves", "evaluated", "ms a cell", "hidden, %",
                  "of buildings, %", "of cars, %", "over budget", "bytes, differences", "bytes, whole"});
  auto const run = [&](std::string const& name, CellQuery const& query, PreprocessOptions const& options) {
    oneapi::tbb::global_control const one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
    PreprocessedCells cells;
    double const seconds =
      median_seconds<ProcessorClock>(1, 0, [&] { cells = preprocess(query, initial, polygons, options); });
    double buildings = 0, moving_polygons = 0, over = 0;
    std::vector<ViewCell> leaves;
    std::vector<DeltaSets::Objects> sets;
    auto const n = static_cast<double>(cells.leaves.size());
    for (auto const& leaf : cells.leaves) {
      for (auto const o : leaf.set.set.visible)
        (scene.objects[o].occludes ? buildings : moving_polygons) += static_cast<double>(polygons[o]) / n;
      over += leaf.polygons > options.budget ? 1 : 0;
      leaves.push_back(leaf.cell);
      sets.push_back(leaf.set.set.visible);
    }
    DeltaSets const stored(std::move(leaves), sets, static_cast<std::uint32_t>(scene.objects.size()));
    auto const bytes = stored_sizes(stored);
    table.add({name, double(options.budget), double(initial.size()), n, double(cells.evaluated),
               1e3 * seconds / double(cells.evaluated),
               percent_hidden(buildings + moving_polygons, all_buildings + all_cars),
               percent_hidden(buildings, all_buildings), percent_hidden(moving_polygons, all_cars), over,
               double(bytes.differences), double(bytes.whole)});
  };
  // The first is what the paper's sets hold; here no leaf is within it. At the second most cells stop to be divided.
  for (std::uint64_t const budget : {250'000U, 600'000U}) {
    PreprocessOptions const options{.budget = budget, .min_size = 2};
    run("extended-projection", cell_query(prepared, ExtendedProjection()), options);
    run("occlusion-sweep", cell_query(prepared, OcclusionSweep()), options);
  }
  table.add({"the paper", {}, 1500.0, 6845.0, 12166.0, 810.0, 96.0, {}, {}, {}, 60e6, {}});
  table.notes.emplace_back("Budgets in polygons, of 6 million; cells of at least 2 m; leaves weigh the same in the "
                           "means, large and small.");
}

}  // namespace visibility::bench::extended_projection
