#pragma once

#include "visibility/geometry/box.hpp"

namespace visibility {

/// Closed ball. Requires: finite, radius >= 0.
struct Ball {
  Point3d centre;
  double radius;
  friend bool operator==(Ball const&, Ball const&) = default;
};

/// A box that contains the ball: each bound is rounded outward, so it exceeds the tight box by at most one ulp a side.
inline Box bounding_box(Ball const& b)
{
  auto const below = [r = b.radius](double c) { return r == 0 ? c : std::nextafter(c - r, -HUGE_VAL); };
  auto const above = [r = b.radius](double c) { return r == 0 ? c : std::nextafter(c + r, HUGE_VAL); };
  return {{below(b.centre.x), below(b.centre.y), below(b.centre.z)},
          {above(b.centre.x), above(b.centre.y), above(b.centre.z)}};
}

}  // namespace visibility
