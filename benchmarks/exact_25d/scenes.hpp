#pragma once

#include "experiments.hpp"

#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/height_field.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace visibility::bench::exact_25d {

using Options = visibility::exact_25d::Options;

/// A scene of the paper. "City" is a big generated city, "Random" has slanting top edges.
enum class Paper { vienna, atlanta, city, random };
std::string to_string(Paper);

/// One of our scenes and the one of the paper that it stands for.
struct Source {
  std::string name;  ///< a generator, "gen:...", or a file below the folder of real scenes
  Paper counterpart;
};

/// All counterparts of the paper's scenes, in its order, generated before real. For a smoke run small generated ones.
std::vector<Source> sources(Size);
/// The million-edge city; small for a smoke run.
std::string big_city(Size);

/// A scene with its height field; stays where it is.
struct Model {
  Model(std::string model_name, Scene s);
  Model(Model const&) = delete;
  Model& operator=(Model const&) = delete;

  std::string name;
  Scene scene;
  double build_seconds = 0;  ///< of the field
  std::unique_ptr<HeightField> field;
};
/// Null for a real scene that is not there.
std::unique_ptr<Model> load(std::string const& name);
/// Calls run(source, model) for the sources that are there, one in memory at a time; the others become notes.
void for_each_model(Size, std::vector<std::string>& notes, std::function<void(Source const&, Model const&)> const& run);

struct CellShape {
  double perimeter, height;  ///< m
  double width = HUGE_VAL;   ///< of the base, a rectangle; the base is a square where that is no wider
};
/// What fits into a street of our counterparts, m.
double street_width(Paper);

/// `count` cells that meet no column, from the ground up: each at a random place within 20 m of a random object in the
/// middle half of the scene (by either axis), on the ground of that object and along one of its edges.
/// Fewer if few places are free. The same seed gives the same cells.
std::vector<ViewCell> free_cells(HeightField const&, CellShape const&, int count, std::uint64_t seed = 1);

/// The answer of the exact method; throws std::runtime_error unless it is one.
PotentiallyVisibleSet exact_set(HeightField const&, ViewCell const&);
std::vector<std::uint32_t> difference(std::vector<std::uint32_t> const& a, std::vector<std::uint32_t> const& b);

/// Sums of named numbers over runs.
class Sums {
public:
  void add(std::string const& name, double x) { sums_[name] += x; }
  /// Adds the statistics and the number of visible objects, as "visible".
  void add(PotentiallyVisibleSet const&);
  double operator[](std::string const& name) const { return sums_.contains(name) ? sums_.at(name) : 0; }
  double mean(std::string const& name) const { return (*this)[name] / (*this)["runs"]; }

private:
  std::map<std::string, double> sums_;
};

/// Least-squares exponent e of y ~ x^e. Requires: positive numbers.
double fitted_exponent(std::vector<std::pair<double, double>> const& points);

}  // namespace visibility::bench::exact_25d
