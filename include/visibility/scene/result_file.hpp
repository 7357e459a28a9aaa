#pragma once

#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace visibility {

/// A witness as a result file holds it: exact coordinates, the object by name.
struct NamedWitness {
  std::string object;
  Point3q from, to;
};

/// One entry of a result file, format "visibility-pvs/1": what was asked, what came out, how long it took.
/// Sets from other implementations need no more than `visible`, the guarantee and the cell.
struct Result {
  struct Seconds {
    double read = 0, build = 0, query = 0;
    // However busy the machine is; 0: not measured.
    double processor = 0;        ///< of the thread that answered the query
    double build_processor = 0;  ///< of all threads that built
  };
  std::string source;                       ///< the scene as the user named it
  bool grounded = false;                    ///< the set is that of grounded(scene)
  std::string moving;                       ///< file of moving objects that were looked for, too; empty: none
  std::string occludees;                    ///< another scene that the objects are of; empty: the scene itself
  std::size_t objects = 0, primitives = 0;  ///< of the scene that was looked for
  std::vector<Point3d> cell;                ///< vertices; of a box its eight corners; empty: of no one cell
  std::optional<Box> cell_box;              ///< set iff the cell was given as a box
  std::string method, arithmetic;
  std::map<std::string, std::string> options;  ///< as text; numbers are written as JSON numbers
  Guarantee guarantee = Guarantee::none;
  std::vector<std::string> visible;  ///< sorted, unique
  std::map<std::string, double> statistics;
  Seconds seconds;
  std::vector<NamedWitness> witnesses;  ///< sorted by object
};

/// The cell of a result. Throws BadInput if it is missing or has no interior.
ViewCell cell_of(Result const& result);

/// Indices of result.visible in scene.objects, ascending. Throws BadInput naming the first name the scene lacks.
std::vector<std::uint32_t> objects_of(Result const& result, Scene const& scene);

/// JSON text: one object for one result, an array for several; ends with a newline.
std::string to_json(std::vector<Result> const& results);

/// Reads either form. Throws BadInput with `name` and the place of the fault; unknown keys are ignored, `cell`,
/// `scene`, `method`, `statistics`, `seconds` and `witnesses` may be missing.
std::vector<Result> results_from_json(std::string_view text, std::string const& name);
std::vector<Result> read_results(std::filesystem::path const& file);

/// A JSON list of cells (or a single one): {"min":[x,y,z],"max":[x,y,z]} or {"vertices":[[x,y,z],...]}.
std::vector<ViewCell> cells_from_json(std::string_view text, std::string const& name);
std::vector<ViewCell> read_cells(std::filesystem::path const& file);

}  // namespace visibility
