#pragma once

#include "visibility/methods/exact_25d/explanation.hpp"
#include "visibility/scene/scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <string>
#include <vector>

namespace visibility::exact_25d {

/// JSON text in the format "visibility-lines/1" (docs/result-format.md): what notebooks draw. One object for one
/// explanation, an array for several; ends with a newline. `cells`: those asked about, in the same order.
std::string to_json(Scene const& scene, std::vector<ViewCell> const& cells,
                    std::vector<Explanation> const& explanations);

}  // namespace visibility::exact_25d
