#pragma once

#include "visibility/geometry/box.hpp"

#include <algorithm>
#include <cmath>

namespace visibility {

/// A segment prepared for conservative box tests in floating point: the intervals of the parameter in which it is
/// between the planes of the box, each bound given the room that rounding needs (proofs/segment_probe.md; the idea is
/// that of [Ize13]). Fast culling only; the verdict is segment_meets.
class SegmentProbe {
public:
  SegmentProbe(Point3d const& p, Point3d const& q) : from_(p), x_(p.x, q.x), y_(p.y, q.y), z_(p.z, q.z)
  {
    bounds_.extend(p);
    bounds_.extend(q);
  }

  /// `true` is certain: the closed box and the closed segment share no point. Overflow gives `false`.
  bool certainly_misses(Box const& b) const
  {
    if (!meet(bounds_, b)) return true;
    // Exact first and last parameters are now at most 1 and at least 0.
    double first = 0, last = 1;
    x_.clip(b.min.x - from_.x, b.max.x - from_.x, first, last);
    y_.clip(b.min.y - from_.y, b.max.y - from_.y, first, last);
    z_.clip(b.min.z - from_.z, b.max.z - from_.z, first, last);
    return first > last * (1 + 16 * 0x1p-53) + 0x1p-1000;
  }

private:
  /// One coordinate of the direction.
  class Axis {
  public:
    Axis(double p, double q)
    {
      double const d = q - p, size = std::fabs(d);
      if (!(size >= 0x1p-1021 && size <= 0x1p1021)) return;  // parallel to the planes, or out of the proof's domain
      inverse_ = 1 / d;
      room_ = 0;
    }
    /// Narrows [first, last]; a NaN leaves it as it is.
    void clip(double low, double high, double& first, double& last) const
    {
      double const a = low * inverse_, b = high * inverse_;
      first = std::max(first, std::min(a, b) - room_);
      last = std::min(last, std::max(a, b) + room_);
    }

  private:
    double inverse_ = 0, room_ = HUGE_VAL;
  };

  Point3d from_;
  Axis x_, y_, z_;
  Box bounds_;
};

}  // namespace visibility
