#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/kernel/point.hpp"

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

namespace detail {

/// Bounds of every point within one rounding of the box: what encloses a rounded point's neighbourhood.
class ProbeMargin {
public:
  ProbeMargin() = default;  ///< none: the probe's ends are exact
  /// Room for ends whose coordinates were rounded, in any direction, by at most one unit in the last place.
  ProbeMargin(Point3d const& p, Point3d const& q) : x_(margin(p.x, q.x)), y_(margin(p.y, q.y)), z_(margin(p.z, q.z)) {}
  Box enlarge(Box const& b) const
  {
    if (x_ == 0) return b;
    return {{down(b.min.x, x_), down(b.min.y, y_), down(b.min.z, z_)},
            {up(b.max.x, x_), up(b.max.y, y_), up(b.max.z, z_)}};
  }

private:
  static double margin(double a, double b) { return 0x1p-51 * std::max(std::fabs(a), std::fabs(b)) + 0x1p-1060; }
  static double down(double v, double m) { return std::nextafter(v - m, -HUGE_VAL); }
  static double up(double v, double m) { return std::nextafter(v + m, HUGE_VAL); }
  double x_ = 0, y_ = 0, z_ = 0;
};

inline Point3d rounded(Point3d const& p) { return p; }
inline Point3d rounded(Point3q const& p) { return {CGAL::to_double(p.x), CGAL::to_double(p.y), CGAL::to_double(p.z)}; }

}  // namespace detail

/// The same for a segment whose ends may be rationals: they are rounded, and boxes grow by what that may move.
class EnclosingProbe {
public:
  EnclosingProbe(Point3d const& p, Point3d const& q) : probe_(p, q) {}
  EnclosingProbe(Point3q const& p, Point3q const& q) : EnclosingProbe(around(detail::rounded(p), detail::rounded(q))) {}
  /// Of ends that were rounded by at most one unit in the last place.
  static EnclosingProbe around(Point3d const& p, Point3d const& q)
  {
    EnclosingProbe probe(p, q);
    probe.margin_ = {p, q};
    return probe;
  }

  /// `true` is certain, as above.
  bool certainly_misses(Box const& b) const { return probe_.certainly_misses(margin_.enlarge(b)); }

private:
  SegmentProbe probe_;
  detail::ProbeMargin margin_;
};

}  // namespace visibility
