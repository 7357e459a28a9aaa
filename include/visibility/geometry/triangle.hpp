#pragma once

#include "visibility/geometry/box.hpp"

#include <array>

namespace visibility {

/// Closed triangle; may be degenerate (a segment or a point).
struct Triangle {
  std::array<Point3d, 3> vertices;
};

inline Box bounding_box(Triangle const& t)
{
  Box b;
  for (auto const& v : t.vertices) b.extend(v);
  return b;
}

}  // namespace visibility
