#pragma once

#include "visibility/scene/scene.hpp"

namespace visibility {

/// The scene in which everything below an upper surface is solid down to the scene's lowest height: the reading of a
/// `HeightField`, for methods that know nothing of it. Objects keep their names and their order.
///
/// Boxes, prisms and convex polyhedra are carried down. The column under a triangle becomes a convex polyhedron; a
/// vertical triangle the vertical triangles below its upper boundary, and so do the walls of a prism with an invalid
/// footprint. What lies in the ground, and balls, stay as they are. A note says what was done.
/// Laws: idempotent;  HeightField(grounded(s)) has the upper surface of HeightField(s), and nothing is raised().
/// Requires: a valid scene.  Cost: about 1 kB for each triangle that is not vertical.
Scene grounded(Scene const& scene);

}  // namespace visibility
