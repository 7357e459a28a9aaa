#pragma once

#include "method_arguments.hpp"

#include "visibility/evidence/ray_scene.hpp"
#include "visibility/methods/exact_25d/explanation.hpp"
#include "visibility/scene/height_field.hpp"
#include "visibility/scene/occludees.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"
#include "visibility/viewspace/preprocess.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace visibility::commands {

/// The method of the command line, ready for any number of cells of one scene. May be called from several threads.
class MethodRunner {
public:
  /// Requires: validated arguments; keeps references to the scenes. Builds what the method shares between cells.
  /// `occludees`: given iff the arguments name them. Throws BadInput if the method does not apply to the scene.
  MethodRunner(MethodArguments arguments, Scene const& scene, Scene const* occludees = nullptr);
  /// `progress` is told of steps done, `steps_per_cell` of them for each cell (fewer if a time limit ends the run).
  PotentiallyVisibleSet operator()(ViewCell const& cell, std::function<void(std::uint64_t)> const& progress) const;
  /// The set, and what the arguments ask to be explained.
  std::pair<PotentiallyVisibleSet, exact_25d::Explanation> explain(ViewCell const& cell) const;
  std::uint64_t steps_per_cell() const;
  /// The sets of the finest cells of a partition, each level starting from the one before. `progress` is told of
  /// finished cells of any level. Throws BadInput for a method that cannot refine.
  std::vector<CellSet> refine(Partition const& partition, std::function<void(std::uint64_t)> const& progress) const;

  /// What the preprocess asks. Throws BadInput for a method or arithmetic whose sets may lack visible objects.
  CellQuery query() const;

private:
  MethodArguments arguments_;
  template <Arithmetic A>
  PotentiallyVisibleSet exact_25d(ViewCell const& cell) const;
  PotentiallyVisibleSet exact_25d(ViewCell const& cell) const;
  void split_off_moving(Scene const& scene);
  void require_above_ground(ViewCell const& cell) const;
  PotentiallyVisibleSet strong_occlusion(ViewCell const& cell) const;
  PotentiallyVisibleSet one_cell(ViewCell const& cell) const;

  /// For a method that takes moving objects apart from the others: both, and their positions in the scene.
  struct Apart {
    Scene still, moving;
    std::vector<std::uint32_t> still_objects, moving_objects;
  };

  std::optional<Apart> apart_;
  std::optional<PreparedScene> scene_;
  std::optional<RayScene> rays_;
  std::optional<HeightField> height_field_;
  std::optional<PreparedScene> targets_;
  std::optional<Occludees> occludees_;
};

/// The methods that take the scene as it is.
std::vector<std::string> applicable_methods(Scene const& scene);

}  // namespace visibility::commands
