#pragma once

#include "visibility/scene/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace visibility {

/// A region in which something moves: what moves is drawn while the region is visible. It hides nothing.
/// Source: [Durand00, 6.2].
struct MovingObject {
  std::string name;
  Box region;
  std::uint64_t polygons = 0;  ///< of what moves there, all of it
};

/// The scene and, after its objects, the regions: boxes that do not occlude. A name that occurs twice among them gets
/// "#2", as in a scene. Throws BadInput if a region is not a finite, ordered box, or has the name of an object of the
/// scene.
Scene with_moving_objects(Scene scene, std::span<MovingObject const> moving);

/// The objects that occlude and the others, each as a scene, in order; the second may be without objects.
std::pair<Scene, Scene> split(Scene const& scene);

/// Polygons drawn for each object of with_moving_objects(scene, moving): the primitives of an object of the scene, the
/// polygons of what moves.
std::vector<std::uint64_t> polygon_counts(Scene const& with_moving, std::span<MovingObject const> moving = {});

/// A JSON list of {"name": ..., "min": [x,y,z], "max": [x,y,z]} with "polygons", a count, where it matters. Throws
/// BadInput with `name` and the place of the fault; unknown keys are ignored.
std::vector<MovingObject> moving_objects_from_json(std::string_view text, std::string const& name);
std::vector<MovingObject> read_moving_objects(std::filesystem::path const& file);

}  // namespace visibility
