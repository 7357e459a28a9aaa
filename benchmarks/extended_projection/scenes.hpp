#pragma once

#include "experiments.hpp"

#include "visibility/scene/generators.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace visibility::bench::extended_projection {

/// A generated scene, prepared; stays where it is.
struct Model {
  Model(std::string const& specification, bool inner_bodies);
  Model(Model const&) = delete;
  Model& operator=(Model const&) = delete;

  std::string name;
  Scene scene;
  std::unique_ptr<PreparedScene> prepared;
};

/// Cells of a street of the district about the origin, as wide as the street but for 2 m on either side, 4 m long, from
/// `bottom` to 2 m above the ground, along both streets that cross there.
std::vector<ViewCell> street_cells(int count, double bottom = 0.5);
/// Such cells of another length, of a district turned about the vertical by so many degrees.
std::vector<ViewCell> turned_street_cells(int count, double length, double degrees);
/// Such cells 6 m wide that rise along the street by so many degrees, from half a metre above the ground.
std::vector<ViewCell> tilted_street_cells(int count, double length, double degrees);
/// Cubes among the crowns of the forest, in the free square about the origin.
std::vector<ViewCell> crown_cells(int count, double side);

/// Means over cells.
struct Means {
  double seconds = 0;  ///< processor time
  double visible = 0, hidden_percent = 0, hidden_polygons_percent = 0;
  double occluders = 0, pixels = 0, planes = 0;
};

template <class Method>
Means measure(Model const& model, std::vector<ViewCell> const& cells, Method const& method)
{
  Means m;
  double const n = static_cast<double>(cells.size()), objects = static_cast<double>(model.scene.objects.size());
  double polygons = 0;
  for (auto const& cell : cells) {
    PotentiallyVisibleSet set;
    m.seconds += median_seconds<ProcessorClock>(1, 0, [&] { set = method(*model.prepared, cell); }) / n;
    m.visible += static_cast<double>(set.visible.size()) / n;
    for (auto const o : set.visible) {
      auto const& object = model.scene.objects[o];
      polygons += static_cast<double>(object.triangles.size() + 12 * object.boxes.size()) / n;
    }
    for (auto const& [name, to] : {std::pair{"occluders", &m.occluders}, {"pixels", &m.pixels}, {"planes", &m.planes}})
      if (set.statistics.contains(name)) *to += set.statistics.at(name) / n;
  }
  double const all = static_cast<double>(model.scene.triangles.size() + 12 * model.scene.boxes.size());
  m.hidden_percent = 100 * (1 - m.visible / objects);
  m.hidden_polygons_percent = 100 * (1 - polygons / all);
  return m;
}

/// Objects that guided sampling sees from a cell with so many rays, in the mean: a lower bound of what is visible.
double mean_seen(Model const& model, std::vector<ViewCell> const& cells, std::uint64_t rays);

/// Least-squares exponent e of y ~ x^e. Requires: positive numbers.
double fitted_exponent(std::vector<std::pair<double, double>> const& points);

}  // namespace visibility::bench::extended_projection
