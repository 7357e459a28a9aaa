#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

/// Visibility in one vertical plane, with coordinates u (forward) and z (up): the cell is a rectangle, occluders are
/// gates. Source: [Leyvand03, section 3]; proofs/ray_space.md, "Slices".
namespace visibility::ray_space {

/// The cell in the slice: [u_in, u_out] x [0, height].
struct CellSlice {
  double u_in, u_out, height;
};

/// Bounds of a point of the slice. Requires where it is used: u_low > u_out of the cell.
struct SlicePoint {
  double u_low, u_high, z_low, z_high;
};

/// Slope of the line through (u, z) that supports the cell from above: no sight line from the cell through the point is
/// less steep. It touches the top of the cell at the back if it rises, in front if it falls. Rounded.
inline double upper_tangent(CellSlice const& k, double u, double z)
{
  double const rise = z - k.height;
  return rise >= 0 ? rise / (u - k.u_in) : rise / (u - k.u_out);
}

/// Slope of the line through (u, z) that supports the cell from below: no sight line through the point is steeper.
inline double lower_tangent(CellSlice const& k, double u, double z)
{
  return z >= 0 ? z / (u - k.u_out) : z / (u - k.u_in);
}

/// Least upper and lower tangent over the bounds.
inline double least_upper_tangent(CellSlice const& k, SlicePoint const& p)
{
  return upper_tangent(k, p.z_low >= k.height ? p.u_high : p.u_low, p.z_low);
}
inline double least_lower_tangent(CellSlice const& k, SlicePoint const& p)
{
  return lower_tangent(k, p.z_low >= 0 ? p.u_high : p.u_low, p.z_low);
}
/// Greatest upper and lower tangent over the bounds.
inline double greatest_upper_tangent(CellSlice const& k, SlicePoint const& p)
{
  return upper_tangent(k, p.z_high >= k.height ? p.u_low : p.u_high, p.z_high);
}
inline double greatest_lower_tangent(CellSlice const& k, SlicePoint const& p)
{
  return lower_tangent(k, p.z_high >= 0 ? p.u_low : p.u_high, p.z_high);
}

/// One end of a gate: the slope of its supporting line and the height of that line at the back of the frame (u = -a),
/// and the slope of its separating line. The paper's supporting and separating angles.
struct GateEnd {
  float slope, base, separating;
};

/// A gate: sight lines to what lies beyond it are blocked if they pass below its top and above its bottom. `beyond` is
/// the distance from the back of the frame from which on it holds, exclusive. Of a pixel the gate holds for all lines.
/// An infinite bottom means that no sight line passes below.
struct Gate {
  GateEnd top, bottom;
  float beyond;
};

inline constexpr GateEnd open_bottom{-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                                     -std::numeric_limits<float>::infinity()};

/// A slope beyond all floats is no open bottom: it is +infinity, and blocks nothing.
inline bool reaches_ground(Gate const& g) { return g.bottom.slope == open_bottom.slope; }

/// Whether no line from the cell passes above the top of `lower` and below the bottom of `upper`: that bottom lies
/// under both tangents of that top. Which of the two is nearer does not matter.
inline bool no_gap(Gate const& lower, Gate const& upper)
{
  return upper.bottom.separating <= lower.top.slope && upper.bottom.slope <= lower.top.separating;
}

/// A gate for both together, or nothing if one of them reaches at least as far up and down, or they leave a gap. Its
/// ends are ends of the two: the paper's fused separating lines may belong to different occluders, and then lines pass
/// that it calls blocked (proofs/ray_space.md, "Three walls"; a test keeps the case).  Source: [Leyvand03, figure 9].
inline std::optional<Gate> fused(Gate const& a, Gate const& b)
{
  bool const up = b.top.slope > a.top.slope && b.bottom.slope > a.bottom.slope;
  bool const down = b.top.slope < a.top.slope && b.bottom.slope < a.bottom.slope;
  if (!up && !down) return std::nullopt;
  Gate const &lower = up ? a : b, &upper = up ? b : a;
  if (!no_gap(lower, upper)) return std::nullopt;
  return Gate{upper.top, lower.bottom, std::max(a.beyond, b.beyond)};
}

/// Whether whatever `b` hides is hidden by `a`.
inline bool dominates(Gate const& a, Gate const& b)
{
  return a.top.slope >= b.top.slope && a.bottom.slope <= b.bottom.slope && a.beyond <= b.beyond;
}

}  // namespace visibility::ray_space
