#pragma once

#include "visibility/methods/extended_projection/frame.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cmath>
#include <vector>

namespace visibility::extended_projection {

/// A point whose u and v are at most `error` off, and its w at most `depth_error`.
struct PartPoint {
  Point3d at;
  double error = 0, depth_error = 0;
};

/// A number and a bound of its error.
struct Bounded {
  double value, error;
};

/// A view cell in a frame. Whatever lies at w > near is seen from each of its points in the direction of growing w.
/// In a frame that is turned it is the box around the cell, which contains it; what is hidden from that is from the
/// cell.
struct CellViews {
  CellViews(Frame const& f, ViewCell const& cell);

  Frame frame;
  std::vector<Point3d> vertices;  ///< in the frame
  Box bounds;                     ///< in the frame
  double near;                    ///< the greatest w of the cell, that is bounds.max.z
  bool is_box;
  std::vector<Point2d> profile_u;  ///< the (u, w) of vertices, each once
  std::vector<Point2d> profile_v;  ///< the (v, w) of vertices, each once
};

/// Where the line from c through a point meets the plane w = plane: in one coordinate, p being that coordinate of the
/// point, with ratio = (plane - c.w) / (p.w - c.w). Infinite or NaN if it leaves the doubles.
/// Six roundings; the bound is that of proofs/extended_projection.md, "Views". `error` is that of p, `slack` that of
/// the ratio, as a share of it.
inline Bounded view(double c, double p, double error, double ratio, double slack = 0)
{
  constexpr double u = 0x1p-53;
  double const way = (p - c) * ratio, value = c + way;
  double const rounding = p == c ? 0 : 6 * u * std::fabs(way) + u * std::fabs(value) + 0x1p-1000;
  return {value, rounding + (error * ratio * (1 + slack) + std::fabs(way) * slack) * (1 + 0x1p-40)};
}

/// The share by which (plane - c.w) / (p.w - c.w) may be off; infinite if nothing is known of it.
inline double ratio_slack(PartPoint const& p, double c_w)
{
  if (p.depth_error == 0) return 0;
  double const least = p.at.z - c_w - p.depth_error;
  return least > p.depth_error ? p.depth_error / least * (1 + 0x1p-40) : HUGE_VAL;
}

/// Ratios out of this range are not used: a bound of their error would have to heed underflow.
inline bool in_domain(double ratio) { return ratio >= 0x1p-500 && ratio <= 0x1p500; }

}  // namespace visibility::extended_projection
