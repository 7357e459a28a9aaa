#include "rotation.hpp"

#include <cmath>

namespace visibility::generators {

namespace {

constexpr double pi = 3.14159265358979323846;

struct Disc {
  double x, y, squared;
};

/// Uniform in the unit disc, without its centre.
Disc in_unit_disc(Random& random)
{
  for (;;) {
    double const x = random.around(1), y = random.around(1), s = x * x + y * y;
    if (s < 1 && s > 0) return {x, y, s};
  }
}

}  // namespace

Point2d direction(double degrees)
{
  // Taylor polynomials on [-pi/4, pi/4] (next term < 1e-17), then two doublings for the rest of the circle.
  double const a = degrees / 4 * (pi / 180), s2 = a * a;
  double cosine = 1, sine = 1;
  for (int k = 8; k >= 1; --k) {
    cosine = 1 - cosine * s2 / ((2 * k - 1) * (2 * k));
    sine = 1 - sine * s2 / ((2 * k) * (2 * k + 1));
  }
  Point2d d{cosine, a * sine};
  for (int doubling = 0; doubling < 2; ++doubling) d = {d.x * d.x - d.y * d.y, 2 * d.x * d.y};
  return d;
}

Rotation about_x(double degrees)
{
  auto const [c, s] = direction(degrees);
  return {{{{1, 0, 0}, {0, c, -s}, {0, s, c}}}};
}

Rotation about_y(double degrees)
{
  auto const [c, s] = direction(degrees);
  return {{{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}}};
}

Rotation any_rotation(Random& random)
{
  Disc const first = in_unit_disc(random), second = in_unit_disc(random);
  double const f = std::sqrt((1 - first.squared) / second.squared);
  double const w = first.x, x = first.y, y = second.x * f, z = second.y * f;
  return {{{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
            {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
            {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}}};
}

Point3d in_unit_ball(Random& random)
{
  for (;;) {
    Point3d const p{random.around(1), random.around(1), random.around(1)};
    if (p.x * p.x + p.y * p.y + p.z * p.z <= 1) return p;
  }
}

}  // namespace visibility::generators
