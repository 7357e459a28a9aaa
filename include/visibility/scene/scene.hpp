#pragma once

#include "visibility/geometry/ball.hpp"
#include "visibility/geometry/convex_polyhedron.hpp"
#include "visibility/geometry/triangle.hpp"
#include "visibility/scene/footprint.hpp"
#include "visibility/scene/object.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace visibility {

/// Objects and their primitives as read: every double exact, lengths in metres, z up.
///
/// Boxes, balls, prisms and polyhedra are solid. A triangle is an occluder of its own. Triangles are stored as indices
/// into `vertices` (12 bytes each), so that tens of millions fit.
struct Scene {
  std::string source;              ///< file or generator, as written by the user
  std::vector<std::string> notes;  ///< what a user should know: projection, units, dropped or repaired input
  std::vector<Object> objects;     ///< unique names

  std::vector<Box> boxes;
  std::vector<Ball> balls;
  std::vector<Prism> prisms;
  std::vector<ConvexPolyhedron> polyhedra;
  std::vector<Point3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  std::size_t primitive_count() const
  {
    return boxes.size() + balls.size() + prisms.size() + polyhedra.size() + triangles.size();
  }
  Triangle triangle(std::size_t i) const
  {
    auto const& t = triangles[i];
    return {{vertices[t[0]], vertices[t[1]], vertices[t[2]]}};
  }

  /// Throws std::logic_error naming the broken invariant: finite coordinates, ordered boxes, ranges that tile the
  /// arrays in object order, indices in range, unique names, at least one object.
  void validate() const;
};

/// Tight but for the outward rounding of balls. Requires: the object has a primitive.
Box bounding_box(Scene const& scene, Object const& object);
Box bounding_box(Scene const& scene);

}  // namespace visibility
