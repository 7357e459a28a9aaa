#pragma once

#include "random.hpp"
#include "visibility/evidence/face.hpp"

namespace visibility::detail {

/// A point on an object's face at which a ray is aimed.
struct Aim {
  std::uint32_t object;
  Face face;
  Point3d point;
};

struct Edge {
  Point3d a, b;
};

/// A point of the edge, often near an end.
Point3d on_edge(Random& random, Edge const& edge);

/// Chooses points of objects.
class ObjectPoints {
public:
  explicit ObjectPoints(PreparedScene const& scene) : scene_(scene) {}

  /// A point on a face of the object that looks towards `from` where that is known; often near the face's border, the
  /// upper one above all, for that is what shows first.
  Aim on_face(Random& random, std::uint32_t object, Point3d const& from) const;

  /// A random edge of one of the object's bodies; of a ball, a point of its outline as seen from `from`. With `upper`,
  /// mostly an edge that bounds the body above, where it has such.
  Edge edge(Random& random, std::uint32_t object, Point3d const& from, bool upper) const;

  /// A point at distance `offset` from such an edge.
  Point3d near_edge(Random& random, std::uint32_t object, Point3d const& from, double offset, bool upper) const;

  /// The point nearest to p on some body of the object; of bodies that are not boxes, on one of a few edges.
  Point3d nearest(Random& random, std::uint32_t object, Point3d const& p) const;

  /// Length of the diagonal of the object's bounding box.
  double size(std::uint32_t object) const;

private:
  PreparedScene const& scene_;
};

}  // namespace visibility::detail
