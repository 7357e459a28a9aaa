#pragma once

#include "visibility/methods/ray_space/occlusion_map.hpp"
#include "visibility/methods/ray_space/reach.hpp"
#include "visibility/methods/ray_space/rounding.hpp"

#include <algorithm>
#include <optional>
#include <utility>

/// Which pixels the lines that meet a box in plan belong to. [Leyvand03, section 2.2]; proofs/ray_space.md,
/// "Footprints".
namespace visibility::ray_space {

/// The part of a box that is not behind the cell, as a frame sees it; rounded outward.
struct LocalBox {
  double u0, u1, v0, v1;
  Extent extent;
};

inline bool in_reach(LocalPoint const& p)
{
  return std::fabs(p.u) < Frame::reach && std::fabs(p.v) < Frame::reach && std::fabs(p.z) < Frame::reach;
}

/// Distance from the back of the frame, where nothing behind it is looked at.
inline float near_of(double u, double back)
{
  return std::max(0.0F, float_below(safely_below(u + back) - 0x1p-50 * back));
}
inline float far_of(double u, double back) { return float_above(safely_above(u + back) + 0x1p-50 * back); }

/// None if all of the box is behind the cell. Requires: the box is in reach.
inline std::optional<LocalBox> local_box(Frame const& frame, Box const& box)
{
  LocalPoint const a = frame.local(box.min), b = frame.local(box.max);
  double const back = frame.half_length();
  LocalBox out{
    safely_below(std::min(a.u, b.u)), safely_above(std::max(a.u, b.u)), safely_below(a.v), safely_above(b.v), {}};
  if (out.u1 < -back) return std::nullopt;
  out.u0 = std::max(out.u0, -back);
  out.extent = {near_of(out.u0, back), far_of(out.u1, back), float_below(safely_below(a.z)),
                float_above(safely_above(b.z))};
  return out;
}

/// How far gates of bodies in the box reach at best, as near or as far in it as serves them; anything if the box may
/// reach into the slice of the cell. `stands`: no sight line passes below.
inline Reach reach_of(LocalBox const& b, bool stands, CellSlice const& k)
{
  if (!(b.u0 > k.u_out)) return {Reach::infinity, -Reach::infinity, 0};
  double const rise = double(b.extent.high) - k.height, low = b.extent.low;
  double const top = rise >= 0 ? rise / (b.u0 - k.u_in) : rise / (b.u1 - k.u_out);
  double const bottom = low >= 0 ? low / (b.u1 - k.u_out) : low / (b.u0 - k.u_in);
  return {top, stands ? -Reach::infinity : bottom, b.extent.near};
}

/// Whether the corners of a box have usable local coordinates.
inline bool in_reach(Frame const& frame, Box const& box)
{
  return in_reach(frame.local(box.min)) && in_reach(frame.local(box.max));
}

/// What rows and columns of a footprint are wider by, for rounding.
inline double slack_of(Frame const& frame, LocalBox const& b)
{
  return frame.margin({std::max(std::fabs(b.u0), std::fabs(b.u1)), std::max(std::fabs(b.v0), std::fabs(b.v1)), 0});
}

/// The rows that the box's footprint meets: from first on, up to but without second.
inline std::pair<int, int> rows_of(Frame const& frame, LocalBox const& b)
{
  // Lines with |s| at most that of the frame reach the box with slopes between these; one that has all its v on one
  // side, further than lines that fall behind the middle of the cell get, only where u > 0.
  double const s = frame.s(frame.columns()) + slack_of(frame, b), t = frame.t(frame.rows());
  double const low = b.v0 - s, high = b.v1 + s, behind = t * std::max(0.0, -b.u0);
  double t0 = -t, t1 = t;
  if (b.u0 > 0) {
    t0 = low / (low < 0 ? b.u0 : b.u1), t1 = high / (high > 0 ? b.u0 : b.u1);
  } else if (low > behind || high < -behind) {
    if (!(b.u1 > 0)) return {0, 0};
    (low > behind ? t0 : t1) = (low > behind ? low : high) / b.u1;
  }
  int const rows = frame.rows();
  double const step = frame.t(1) - frame.t(0);
  int const first = std::max(0, static_cast<int>(std::clamp((t0 - frame.t(0)) / step - 2, -1.0, double(rows))));
  int const last = std::min(rows, static_cast<int>(std::clamp((t1 - frame.t(0)) / step + 3, 0.0, double(rows))));
  return {first, last};
}

/// Calls in_row(row, from, to) with the pixels that the box's footprint meets, until it returns false. Returns whether
/// it always returned true. Begins with row `start` if it is one of them.
template <class InRow>
bool every_row(Frame const& frame, LocalBox const& b, InRow&& in_row, int start = 0)
{
  double const slack = slack_of(frame, b);
  auto const [first, last] = rows_of(frame, b);
  auto const visit = [&](int row) {
    double const t0 = frame.t(row), t1 = frame.t(row + 1);
    double const least = std::min(std::min(t0 * b.u0, t0 * b.u1), std::min(t1 * b.u0, t1 * b.u1));
    double const most = std::max(std::max(t0 * b.u0, t0 * b.u1), std::max(t1 * b.u0, t1 * b.u1));
    int const from = frame.columns_below(b.v0 - most - slack), to = frame.columns_from(b.v1 - least + slack);
    return from >= to || in_row(row, from, to);
  };
  if (start <= first || start >= last) start = first;
  for (int row = start; row < last; ++row)
    if (!visit(row)) return false;
  for (int row = first; row < start; ++row)
    if (!visit(row)) return false;
  return true;
}

}  // namespace visibility::ray_space
