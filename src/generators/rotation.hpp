#pragma once

#include "random.hpp"

#include "visibility/kernel/point.hpp"

#include <array>

namespace visibility::generators {

/// A rotation of space: rows of its matrix, orthonormal up to rounding.
struct Rotation {
  std::array<Point3d, 3> rows;

  Point3d operator()(Point3d const& p) const
  {
    auto const dot = [&p](Point3d const& r) { return r.x * p.x + r.y * p.y + r.z * p.z; };
    return {dot(rows[0]), dot(rows[1]), dot(rows[2])};
  }
};

/// (cos, sin) of an angle in degrees, to about 1e-15 and the same bits everywhere: the C library's may differ in the
/// last place. Requires: |degrees| <= 180.
Point2d direction(double degrees);

Rotation about_x(double degrees);
Rotation about_y(double degrees);

/// Uniform over all rotations: a uniform unit quaternion [Marsaglia 1972], by sqrt alone.
Rotation any_rotation(Random& random);

/// Uniform in the ball of radius 1 about the origin.
Point3d in_unit_ball(Random& random);

}  // namespace visibility::generators
