#pragma once

#include "visibility/scene/read_scene.hpp"

#include <string>

namespace CLI {
class App;
}

namespace visibility::commands {

/// The SCENE argument that most commands share: a file, or a generator written `gen:KIND,key=value,...`, with the
/// options that say how it is to be read.
struct SceneArgument {
  std::string scene;
  ReadOptions options;
  bool grounded = false;

  void add_to(CLI::App& command);
  Scene load() const;                                 ///< throws BadInput
  Scene load_another(std::string const& name) const;  ///< another scene, read the same way, not grounded
};

}  // namespace visibility::commands
