#pragma once

#include "parameters.hpp"

#include "visibility/scene/scene_builder.hpp"

namespace visibility::generators {

/// What one file of this folder contributes: a description and the function that makes the scene.
struct Kind {
  GeneratorKind description;
  void (*make)(Parameters const&, SceneBuilder&);
};

Kind city();
Kind spheres();
Kind circles();
Kind slanted();
Kind urban();
Kind box_field();
Kind forest();
Kind district();

}  // namespace visibility::generators
