#pragma once

#include "visibility/geometry/box.hpp"

#include <array>
#include <span>

namespace visibility::strong_occlusion {

/// What an occluder is sought for: the convex hull of some points, with their bounds.
struct Target {
  std::span<Point3d const> vertices;
  Box bounds;
  bool is_box = false;  ///< the vertices are Box::corners() of the bounds, in their order
};

inline Target target_of(std::span<Point3d const> vertices)
{
  Target t{vertices, {}, false};
  for (auto const& v : vertices) t.bounds.extend(v);
  return t;
}

/// A box with its corners, to be kept while they are looked at.
struct BoxTarget {
  std::array<Point3d, 8> corners;
  Box box;
  explicit BoxTarget(Box const& b) : corners(b.corners()), box(b) {}
  Target target() const { return {corners, box, true}; }
};

}  // namespace visibility::strong_occlusion
