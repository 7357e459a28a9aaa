#pragma once

#include "visibility/scene/moving_objects.hpp"
#include "visibility/scene/read_scene.hpp"

#include <string>
#include <vector>

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
  std::string moving;  ///< file of moving objects; empty: none

  void add_to(CLI::App& command);
  Scene load() const { return load(load_moving()); }  ///< throws BadInput
  /// The scene and, after its objects, these. Throws BadInput.
  Scene load(std::vector<MovingObject> const& moving_objects) const;
  std::vector<MovingObject> load_moving() const;      ///< throws BadInput
  Scene load_another(std::string const& name) const;  ///< another scene, read the same way, not grounded
};

}  // namespace visibility::commands
