#pragma once

#include "visibility/methods/ray_space/rounding.hpp"
#include "visibility/methods/ray_space/vertical_slice.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace visibility::ray_space {

/// The best ends of a gate that chords of a body have given so far, for all lines of a pixel.
/// proofs/ray_space.md, "Bounds over a pixel".
struct GateEnds {
  /// `far`: the largest u.
  struct End {
    double slope, separating, far;
  };
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  End top{-infinity, -infinity, 0}, bottom{infinity, infinity, 0};

  /// Those of an upright body from `bottom` to `top`, of which all lines cross chords in plan, the nearest and the
  /// farthest of them within these u. At a constant height every tangent is monotone in the distance, so one of the two
  /// is best. `scale`: of the frame, for rounding.
  static GateEnds of_upright(CellSlice const& k, SlicePoint const& near, SlicePoint const& far, double bottom,
                             double top, bool open_below, double scale)
  {
    double const slack = 0x1p-47 * (std::fabs(bottom) + std::fabs(top) + scale);
    auto const &for_top = top - slack >= k.height ? near : far,
               &for_bottom = open_below || bottom + slack < 0 ? near : far;
    SlicePoint const upper{for_top.u_low, for_top.u_high, top - slack, top + slack};
    SlicePoint const lower{for_bottom.u_low, for_bottom.u_high, bottom - slack, bottom + slack};
    return {
      {least_upper_tangent(k, upper), least_lower_tangent(k, upper), upper.u_high},
      {open_below ? -infinity : greatest_lower_tangent(k, lower), greatest_upper_tangent(k, lower), lower.u_high}};
  }

  bool lacks_one() const { return top.slope == -infinity || bottom.slope == infinity; }

  /// Crossings at the corners of the pixel, or one that bounds them all if the chord is level. `far`: their largest u.
  void take_top(CellSlice const& k, std::span<SlicePoint const> extremes, double far)
  {
    // One corner shows where a chord cannot be better than those before it.
    if (!(least_upper_tangent(k, extremes.front()) > top.slope)) return;
    End e{infinity, infinity, far};
    for (auto const& x : extremes) {
      e.slope = std::min(e.slope, least_upper_tangent(k, x));
      e.separating = std::min(e.separating, least_lower_tangent(k, x));
    }
    if (e.slope > top.slope) top = e;
  }
  void take_bottom(CellSlice const& k, std::span<SlicePoint const> extremes, double far)
  {
    if (!(greatest_lower_tangent(k, extremes.front()) < bottom.slope)) return;
    End e{-infinity, -infinity, far};
    for (auto const& x : extremes) {
      e.slope = std::max(e.slope, greatest_lower_tangent(k, x));
      e.separating = std::max(e.separating, greatest_upper_tangent(k, x));
    }
    if (e.slope < bottom.slope) bottom = e;
  }
  /// A chord that no sight line passes below.
  void take_ground(double far)
  {
    if (bottom.slope != -infinity || far < bottom.far) bottom = {-infinity, -infinity, far};
  }

  /// The gate, rounded to the safe side; it holds from `beyond` on. `back`: half the length of the cell, where heights
  /// are taken. Requires: !lacks_one().
  Gate gate(CellSlice const& k, double back, float beyond) const
  {
    return {top_end(k, back), bottom_end(k, back), beyond};
  }
  /// From where on it holds, from the back of the frame.
  float distance(double back) const { return float_above(safely_above(std::max(top.far, bottom.far) + back)); }

private:
  GateEnd top_end(CellSlice const& k, double back) const
  {
    GateEnd e{float_below(safely_below(top.slope)), 0, float_below(safely_below(top.separating))};
    double const run = (e.slope >= 0 ? k.u_in : k.u_out) + back, drop = double(e.slope) * run;
    e.base = float_below(k.height - drop - 0x1p-47 * (k.height + std::fabs(double(e.slope)) * 2 * back));
    return e;
  }
  GateEnd bottom_end(CellSlice const& k, double back) const
  {
    if (bottom.slope == -infinity) return open_bottom;
    GateEnd e{float_above(safely_above(bottom.slope)), 0, float_above(safely_above(bottom.separating))};
    double const run = (e.slope >= 0 ? k.u_out : k.u_in) + back, drop = double(e.slope) * run;
    e.base = float_above(-drop + 0x1p-47 * std::fabs(double(e.slope)) * 2 * back);
    return e;
  }
};

}  // namespace visibility::ray_space
