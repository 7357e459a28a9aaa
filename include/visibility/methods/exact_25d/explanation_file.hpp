#pragma once

#include "visibility/methods/exact_25d/explanation.hpp"
#include "visibility/scene/scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace visibility::exact_25d {

/// An entry of an explanation file: the vertices of the view cell, and what was found.
struct ExplainedCell {
  std::vector<Point3d> cell;
  Explanation explanation;
};

/// JSON text in the format "visibility-lines/1" (docs/result-format.md): what notebooks draw. One object for one
/// explanation, an array for several; ends with a newline. `cells`: those asked about, in the same order.
std::string to_json(Scene const& scene, std::vector<ViewCell> const& cells,
                    std::vector<Explanation> const& explanations);

/// Reads the same, one entry or an array; exact positions of edges where the file has them, else the rounded ones.
/// Throws BadInput with `name` and the place of the fault; naming the first object that the scene does not have.
std::vector<ExplainedCell> explanations_from_json(std::string_view text, std::string const& name, Scene const& scene);
std::vector<ExplainedCell> read_explanations(std::filesystem::path const& file, Scene const& scene);

}  // namespace visibility::exact_25d
