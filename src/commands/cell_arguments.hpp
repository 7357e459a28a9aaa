#pragma once

#include "visibility/drawing/plan_picture.hpp"
#include "visibility/scene/view_cell.hpp"
#include "visibility/viewspace/partition.hpp"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace visibility::commands {

/// The view cells of a command: `--cell X0,Y0,Z0,X1,Y1,Z1` any number of times, `--cells FILE` a JSON list; or a region
/// to be divided, `--region X0,Y0,Z0,X1,Y1,Z1` with `--cell-size S` or `SX,SY,SZ` for each level, the coarsest first.
struct CellArguments {
  std::vector<std::string> boxes;
  std::string file;
  std::string region;
  std::vector<std::string> sizes;

  void add_to(CLI::App& command);
  /// The cells one by one; at least one. Throws BadInput. Requires: no partition().
  std::vector<ViewCell> load() const;
  /// The divided region, if one was given. Throws BadInput.
  std::optional<Partition> partition() const;
};

/// The value X0,Y0,X1,Y1 of an option. Throws BadInput naming the option.
PlanRegion parse_plan_region(std::string const& option, std::string const& text);
/// A point X,Y,Z. Throws BadInput naming the option.
Point3d parse_point(std::string const& option, std::string const& text);

}  // namespace visibility::commands
