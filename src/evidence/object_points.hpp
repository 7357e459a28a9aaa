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

/// Chooses points of objects.
class ObjectPoints {
public:
  explicit ObjectPoints(PreparedScene const& scene) : scene_(scene) {}

  /// A point on a face of the object that looks towards `from` where that is known; often near the face's border, the
  /// upper one above all, for that is what shows first.
  Aim on_face(Random& random, std::uint32_t object, Point3d const& from) const;

  /// A point at distance about `offset` from a random edge of one of the object's bodies; from a ball's outline
  /// as seen from `from`. With `upper`, from edges that bound the body above, where it has such.
  Point3d near_edge(Random& random, std::uint32_t object, Point3d const& from, double offset, bool upper) const;

  /// Length of the diagonal of the object's bounding box.
  double size(std::uint32_t object) const;

private:
  PreparedScene const& scene_;
};

}  // namespace visibility::detail
