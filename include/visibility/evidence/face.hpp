#pragma once

#include "visibility/scene/prepared_scene.hpp"

#include <cstdint>
#include <optional>

namespace visibility {

/// A face of an object as it is seen: the rectangles of a box, the walls, roof and floor of a prism, the facets of a
/// polyhedron, a triangle, the sphere of a ball. Roof and floor are named by the triangles of their convex pieces.
struct Face {
  enum class Kind : std::uint8_t { box, wall, roof, floor, facet, triangle, sphere };
  Kind kind = Kind::box;
  /// Position among the scene's boxes, prisms (walls), polyhedra, triangles or balls; among the bodies for roof, floor.
  std::uint32_t primitive = 0;
  /// Box: 2 axis + (max side ? 1 : 0); wall: ring edges counted through all rings; roof, floor: i-th triangle of the
  /// fan from the piece's first corner; polyhedron: the facet.
  std::uint32_t part = 0;
  friend bool operator==(Face const&, Face const&) = default;
};

/// A point of the relative interior of a face: exact where it has no double coordinates, and rounded.
struct FacePoint {
  Point3d rounded;
  std::optional<Point3q> exact;  ///< empty: `rounded` is the point itself
  Point3q point() const { return exact ? *exact : visibility::exact(rounded); }
};

/// A point of the relative interior of the face, near `wanted` (nearer than 2^-16 of the face's size if `wanted` lies
/// on the face). Empty if the face has no relative interior, or none with points that are cheap to name.
std::optional<FacePoint> point_inside(PreparedScene const& scene, Face const& face, Point3d const& wanted);

/// Some point in the middle of the face, rounded; for a sphere the point towards `from`.
Point3d middle(PreparedScene const& scene, Face const& face, Point3d const& from);

/// Whether the point lies in the relative interior of a face of the object. Exact.
bool in_face_interior(PreparedScene const& scene, std::uint32_t object, Point3q const& point);

/// Ends of a wall's footprint edge: ring edges counted through all rings. Requires: edge < number of ring points.
std::pair<Point2d, Point2d> wall_ends(Prism const& prism, std::uint32_t edge);

}  // namespace visibility
