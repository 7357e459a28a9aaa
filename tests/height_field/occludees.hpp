#pragma once

#include "support/height_field_oracle.hpp"

namespace visibility::test {

using Polygon = std::vector<Point3d>;

/// A vertical rectangle over the segment ab.
inline Polygon upright(Point2d a, Point2d b, double low, double high)
{
  return {{a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, high}, {a.x, a.y, high}};
}
/// A rectangle in plan with heights z0 at x0 and z1 at x1.
inline Polygon ramp(double x0, double x1, double y0, double y1, double z0, double z1)
{
  return {{x0, y0, z0}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z0}};
}

}  // namespace visibility::test
