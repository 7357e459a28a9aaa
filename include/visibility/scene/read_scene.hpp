#pragma once

#include "visibility/scene/scene.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace visibility {

/// How footprint coordinates are to be understood.
enum class CoordinateUnit {
  automatic,  ///< degrees if the file's reference system says so, or if it names none and everything fits on a globe
  metres,     ///< taken as they are
  degrees     ///< longitude, latitude; projected to metres about the centre
};

/// What a file does not say about itself. Empty names mean: try the usual ones (docs/readers.md lists them).
struct ReadOptions {
  std::string height_property;  ///< GeoJSON: height of a footprint in metres
  std::string ground_property;  ///< GeoJSON: elevation of its floor in metres
  std::string object_property;  ///< PLY: integer or real property of a face that tells objects apart
  CoordinateUnit coordinates = CoordinateUnit::automatic;  ///< GeoJSON
};

/// The kinds of file that are told apart by their name; JSON files are told apart by what they contain.
enum class SceneFormat {
  obj,  ///< Wavefront OBJ
  ply,  ///< PLY: ascii, binary of either byte order
  json  ///< CityJSON, CityJSONSeq, GeoJSON, GeoJSONSeq, visibility-scene/1; one document or one a line
};

/// The scene in a file: `.obj`, `.ply`, `.json`, `.jsonl`, `.geojson`, `.geojsonl`, ..., each also with `.gz` appended;
/// other names are judged by content. Every coordinate is the double nearest to the decimal number written in the file.
/// Throws BadInput if the file is missing, damaged or holds no geometry.
Scene read_scene(std::filesystem::path const& path, ReadOptions const& options = {});

/// The same from memory. `source` names the input in messages and becomes Scene::source.
Scene read_scene_text(std::string_view bytes, SceneFormat format, std::string const& source,
                      ReadOptions const& options = {});

}  // namespace visibility
