#pragma once

#include "visibility/scene/scene.hpp"

#include <vector>

namespace visibility::detail {

/// The closed convex pieces of one object's triangles, and the triangles that belong to none.
struct MeshPieces {
  std::vector<ConvexPolyhedron> convex;
  std::vector<std::uint32_t> loose;  ///< positions in scene.triangles, ascending
};

/// Splits the triangles into components connected through edges and keeps as solids those that bound a convex
/// polyhedron exactly; an inside-out one is turned round. Vertices are the same if they have one index, and, in a
/// second pass over what is left, if they have equal coordinates.
MeshPieces mesh_pieces(Scene const& scene, IndexRange triangles);

}  // namespace visibility::detail
