#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/kernel/bounded.hpp"

#include <span>
#include <vector>

namespace visibility::strong_occlusion {

/// Seen along a coordinate axis, the sight lines from a box-shaped cell to a target lie between supporting lines of the
/// two. Each is itself a sight line, from corner c of the cell in some quadrant to a vertex s of the target, with
/// everything else on its inner side. A body that meets it, and any box around the body, must reach the line: the
/// box's own corner in that quadrant must not be strictly inside. Culling only: `certainly_inside` is certified in
/// floating point, and which lines are taken is a choice.
class Silhouette {
public:
  /// Forgets all lines.
  void clear() { lines_.clear(); }

  /// The line from c to s as seen along the axis that is neither u nor v, if its outward normal is in the quadrant
  /// (up_u, up_v). Requires: cs is a sight line.
  void add(double Point3d::*u, double Point3d::*v, bool up_u, bool up_v, Point3d const& c, Point3d const& s)
  {
    using bounded::Input;
    auto const du = Input{s.*u} - Input{c.*u}, dv = Input{s.*v} - Input{c.*v};
    // The normal (-dv, du), or its opposite, is in the quadrant iff du and dv have the signs for it.
    if (du.v == 0 || dv.v == 0) return;
    bool const left = (du.v > 0) == up_v;
    if (((dv.v < 0) == up_u) != left) return;
    Point3d Box::*const max = &Box::max;
    Point3d Box::*const min = &Box::min;
    double const sign = left ? 1 : -1;
    lines_.push_back({u, v, up_u ? max : min, up_v ? max : min, c.*u, c.*v, {sign * du.v}, {sign * dv.v}});
  }

  /// Whether the box certainly fails to reach one of the lines.
  bool certainly_inside_one(Box const& box)
  {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!lines_[i].certainly_inside(box)) continue;
      std::swap(lines_[i], lines_.front());  // likely to decide for the next box as well
      return true;
    }
    return false;
  }

private:
  struct Line {
    double Point3d::*u;
    double Point3d::*v;
    Point3d Box::*end_u;
    Point3d Box::*end_v;
    double pu, pv;
    bounded::Leaf<1> du, dv;

    bool certainly_inside(Box const& box) const
    {
      using bounded::Input;
      auto const x = Input{box.*end_u.*u} - Input{pu}, y = Input{box.*end_v.*v} - Input{pv};
      return bounded::certified_sign(du * y - dv * x) == Sign::negative;
    }
  };
  std::vector<Line> lines_;
};

}  // namespace visibility::strong_occlusion
