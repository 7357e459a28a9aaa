#pragma once

#include "visibility/kernel/point.hpp"

#include <span>

namespace visibility::exact_25d {

/// The height of a plane over a point of the plan, from three corners that are not in line.
class TopPlane {
public:
  using R = RationalNumber;

  explicit TopPlane(std::span<Point3d const> corners) : origin_(exact(corners[0]))
  {
    Point3q const a = exact(corners[1]), b = exact(corners[2]);
    R const ax = a.x - origin_.x, ay = a.y - origin_.y, az = a.z - origin_.z;
    R const bx = b.x - origin_.x, by = b.y - origin_.y, bz = b.z - origin_.z, area = ax * by - ay * bx;
    if (area == 0) return;  // flat, first corners in line
    slope_x_ = (az * by - ay * bz) / area;
    slope_y_ = (ax * bz - az * bx) / area;
  }
  R at(R const& x, R const& y) const { return origin_.z + slope_x_ * (x - origin_.x) + slope_y_ * (y - origin_.y); }
  /// How far p is above.
  R above(Point3q const& p) const { return p.z - at(p.x, p.y); }

private:
  Point3q origin_;
  R slope_x_ = 0, slope_y_ = 0;
};

}  // namespace visibility::exact_25d
