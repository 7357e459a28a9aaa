#pragma once

#include "visibility/scene/view_cell.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace visibility::commands {

/// The view cells of a command: `--cell X0,Y0,Z0,X1,Y1,Z1` any number of times, `--cells FILE` a JSON list.
struct CellArguments {
  std::vector<std::string> boxes;
  std::string file;

  void add_to(CLI::App& command);
  std::vector<ViewCell> load() const;  ///< throws BadInput; at least one cell
};

}  // namespace visibility::commands
