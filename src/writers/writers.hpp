#pragma once

#include "visibility/scene/scene.hpp"

#include <ostream>
#include <string>
#include <vector>

/// The writers behind write_scene. All throw BadInput if the format cannot hold an object.
namespace visibility::writers {

void write_native(std::ostream& out, Scene const& scene);
void write_obj(std::ostream& out, Scene const& scene);
void write_ply(std::ostream& out, Scene const& scene);
void write_geojson(std::ostream& out, Scene const& scene, bool lines);

/// The faces of the object's boxes, prisms and polyhedra, outward counterclockwise; a prism's roof and floor come as
/// convex pieces. Throws BadInput for balls and for footprints that are no polygon.
std::vector<std::vector<Point3d>> solid_faces(Scene const& scene, Object const& object);

/// `text` as a JSON string, with quotes.
std::string json_string(std::string const& text);

[[noreturn]] void cannot_hold(Object const& object, std::string const& what);

}  // namespace visibility::writers
