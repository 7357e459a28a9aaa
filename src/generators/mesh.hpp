#pragma once

#include "visibility/scene/scene_builder.hpp"

#include <array>
#include <span>

namespace visibility::generators {

/// All meshes are closed, with facets counterclockwise seen from outside and vertices of their own, so that each is a
/// solid that the library finds again as a convex body.

/// Vertical prism over a convex polygon, counterclockwise. Its walls are vertical and its top is level exactly,
/// whatever the rounding of the footprint, so it is exactly convex: 4 m - 4 triangles for m corners.
void add_prism(SceneBuilder& scene, std::span<Point2d const> footprint, double bottom, double top);

/// Convex hull of nearly a box: corners as Box::corner numbers them, right-handed. Twelve triangles.
///
/// The corners of a turned box are rounded, so its faces are not exactly flat: a face of corners a, b, c, d has two
/// diagonals, and one of them makes the pair of triangles bulge outward. That one is chosen, by the exact sign of
/// orient3d. Then the surface is convex at every edge (at the twelve edges of the box by nearly 90 degrees, at the six
/// diagonals by this choice), and a closed surface that is convex at every edge bounds a convex polyhedron.
/// Requires: rounding is all that keeps the corners from being those of a box.
void add_hexahedron(SceneBuilder& scene, std::array<Point3d, 8> const& corners);

/// Two triangles between a, b, c, d (counterclockwise from outside) with the diagonal that bulges outward.
void add_convex_quad(SceneBuilder& scene, std::array<std::uint32_t, 4> const& corners,
                     std::array<Point3d, 4> const& points);

}  // namespace visibility::generators
