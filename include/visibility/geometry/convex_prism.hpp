#pragma once

#include "visibility/geometry/box.hpp"

#include <vector>

namespace visibility {

/// Vertical prism over a convex polygon: closed, with interior.
/// Invariant (`validate`): at least 3 footprint points in counterclockwise order, every turn non-right, area > 0,
/// bottom < top.
struct ConvexPrism {
  std::vector<Point2d> footprint;
  double bottom = 0, top = 0;

  void validate() const;  ///< throws std::logic_error naming the broken invariant
};

inline Box bounding_box(ConvexPrism const& p)
{
  Box b;
  for (auto const& v : p.footprint) b.extend(Point3d{v.x, v.y, p.bottom});
  b.max.z = p.top;
  return b;
}

}  // namespace visibility
