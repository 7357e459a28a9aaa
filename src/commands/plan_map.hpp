#pragma once

#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <string>

namespace visibility::commands {

/// The scene from above in characters, north up, about square metres per cell of text: `#` has a visible object, `.`
/// only hidden ones, `C` the view cell. For a person to look at; nothing is decided by it.
std::string plan_map(Scene const& scene, ViewCell const& cell, PotentiallyVisibleSet const& set, int columns = 78);

}  // namespace visibility::commands
