#pragma once

#include "visibility/geometry/box.hpp"

#include <cmath>

namespace visibility {

/// A segment prepared for conservative box tests in floating point: the separating-axis test with every comparison
/// given the room that rounding needs (proofs/segment_probe.md). Fast culling only; the verdict is segment_meets.
class SegmentProbe {
public:
  SegmentProbe(Point3d const& p, Point3d const& q)
    : middle_{0.5 * p.x + 0.5 * q.x, 0.5 * p.y + 0.5 * q.y, 0.5 * p.z + 0.5 * q.z}, half_{0.5 * q.x - 0.5 * p.x,
                                                                                          0.5 * q.y - 0.5 * p.y,
                                                                                          0.5 * q.z - 0.5 * p.z}
  {
    bounds_.extend(p);
    bounds_.extend(q);
  }

  /// `true` is certain: the closed box and the closed segment share no point. Overflow gives `false`.
  bool certainly_misses(Box const& b) const
  {
    if (!meet(bounds_, b)) return true;
    double const mx = 0.5 * b.min.x + 0.5 * b.max.x - middle_.x, ex = 0.5 * b.max.x - 0.5 * b.min.x;
    double const my = 0.5 * b.min.y + 0.5 * b.max.y - middle_.y, ey = 0.5 * b.max.y - 0.5 * b.min.y;
    double const mz = 0.5 * b.min.z + 0.5 * b.max.z - middle_.z, ez = 0.5 * b.max.z - 0.5 * b.min.z;
    // Every coordinate is within `reach` of the origin, so each of the differences above is off by at most 4u reach.
    double const rx = reach(b.min.x, b.max.x, bounds_.min.x, bounds_.max.x);
    double const ry = reach(b.min.y, b.max.y, bounds_.min.y, bounds_.max.y);
    double const rz = reach(b.min.z, b.max.z, bounds_.min.z, bounds_.max.z);
    return separates(mx, my, half_.x, half_.y, ex, ey, rx, ry) || separates(mx, mz, half_.x, half_.z, ex, ez, rx, rz) ||
           separates(my, mz, half_.y, half_.z, ey, ez, ry, rz);
  }

private:
  static double reach(double a, double b, double c, double d)
  {
    // the constant stands for the halving of subnormals
    return std::max(std::max(std::fabs(a), std::fabs(b)), std::max(std::fabs(c), std::fabs(d))) + 0x1p-1000;
  }
  static bool separates(double mx, double my, double hx, double hy, double ex, double ey, double rx, double ry)
  {
    constexpr double slack = 64 * 0x1p-53;
    double const distance = std::fabs(mx * hy - my * hx);
    double const extent = ex * std::fabs(hy) + ey * std::fabs(hx);
    return distance > extent +
                        slack * (rx * (std::fabs(hy) + std::fabs(my) + ey) + ry * (std::fabs(hx) + std::fabs(mx) + ex) +
                                 slack * rx * ry) +
                        0x1p-960;
  }

  Point3d middle_, half_;
  Box bounds_;
};

}  // namespace visibility
