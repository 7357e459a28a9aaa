#pragma once

#include "visibility/scene/scene.hpp"

#include <filesystem>
#include <iosfwd>

namespace visibility {

enum class SceneFileKind {
  native,         ///< visibility-scene/1 JSON: every kind of primitive, read back bit for bit
  obj,            ///< triangles, and the faces of boxes, prisms and polyhedra as polygons; no balls
  ply,            ///< the same in binary; objects by the `object` property of a face, names are lost
  geojson,        ///< prisms and boxes as footprints with height
  geojson_lines,  ///< the same, one feature a line
};

/// The kind that the extension names: .json, .obj, .ply, .geojson, .geojsonl. Throws BadInput for others.
SceneFileKind scene_file_kind(std::filesystem::path const& path);

/// Numbers are the shortest decimals that read back as the same doubles. Throws BadInput naming the object if the
/// format cannot hold it; none holds objects that do not occlude.
void write_scene(std::ostream& out, Scene const& scene, SceneFileKind kind);

/// Writes to a temporary file in the same folder and renames it: no half-written file remains.
/// Throws BadInput as above or if the file cannot be written.
void write_scene(std::filesystem::path const& path, Scene const& scene);

}  // namespace visibility
