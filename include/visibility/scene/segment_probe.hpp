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
    auto const clip = [&](Axis const& axis, double low, double high) {
      double const s = low * axis.inverse, t = high * axis.inverse;
      first = std::max(first, std::min(s, t));
      last = std::min(last, std::max(s, t) + axis.room);
    };
    clip(x_, b.min.x - from_.x, b.max.x - from_.x);
    clip(y_, b.min.y - from_.y, b.max.y - from_.y);
    clip(z_, b.min.z - from_.z, b.max.z - from_.z);
    return first > last * (1 + 16 * 0x1p-53) + 0x1p-1000;
  }

private:
  /// One coordinate of the direction. With room = infinity it constrains nothing: both parameters are 0 (or NaN, which
  /// the order of arguments of std::max and std::min makes harmless), and the last one is moved out of the way.
  struct Axis {
    double inverse = 0, room = HUGE_VAL;
    Axis(double p, double q)
    {
      double const d = q - p, size = std::fabs(d);
      if (!(size >= 0x1p-1021 && size <= 0x1p1021)) return;  // parallel to the planes, or out of the proof's domain
      inverse = 1 / d;
      room = 0;
    }
  };

  Point3d from_;
  Axis x_, y_, z_;
  Box bounds_;
};

}  // namespace visibility
