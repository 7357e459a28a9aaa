#pragma once

#include "visibility/scene/scene_builder.hpp"

#include <string>
#include <vector>

namespace visibility::test {

/// A scene of these boxes, each an object: "box 0", "box 1" and so on.
inline Scene box_scene(std::vector<Box> const& boxes)
{
  SceneBuilder builder("boxes");
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    builder.begin_object("box " + std::to_string(i));
    builder.add(boxes[i]);
  }
  return builder.finish();
}

}  // namespace visibility::test
