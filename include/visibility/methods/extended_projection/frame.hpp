#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/scene/view_cell.hpp"

#include <array>

namespace visibility::extended_projection {

/// Coordinates (u, v, w) for one of six directions: w grows along a coordinate axis or against it, u and v are the
/// other two axes, v the vertical if w is not. The plan may be turned before: x becomes a x + b y, y becomes a y - b x,
/// so that axes are those of an oriented cell. Any a, b will do, (1, 0) turns nothing; then all is exact: coordinates
/// are exchanged and w negated. Otherwise coordinates in the plan are rounded, heights never.
/// Points of a frame are Point3d and Box with x = u, y = v, z = w.
struct Frame {
  double Point3d::*u = &Point3d::x;
  double Point3d::*v = &Point3d::y;
  double Point3d::*w = &Point3d::z;
  bool up = true;
  double a = 1, b = 0;

  bool is_turned() const { return a != 1 || b != 0; }
  bool has_vertical_v() const { return v == &Point3d::z; }

  Point3d operator()(Point3d const& p) const { return exchanged(is_turned() ? turned(p) : p); }
  /// How far off a coordinate in the plan may be: two roundings, twice over.
  double error(Point3d const& p) const
  {
    if (!is_turned()) return 0;
    return 0x1p-51 * std::max(std::fabs(a), std::fabs(b)) * (std::fabs(p.x) + std::fabs(p.y)) + 0x1p-1000;
  }
  /// A box that contains it; the least one, unless turned.
  Box operator()(Box const& box) const;

private:
  Point3d turned(Point3d const& p) const { return {a * p.x + b * p.y, a * p.y - b * p.x, p.z}; }
  Point3d exchanged(Point3d const& p) const { return {p.*u, p.*v, up ? p.*w : -(p.*w)}; }
};

inline constexpr double Point3d::*axis_x = &Point3d::x;
inline constexpr double Point3d::*axis_y = &Point3d::y;
inline constexpr double Point3d::*axis_z = &Point3d::z;

/// The six directions along the axes.
inline constexpr std::array<Frame, 6> frames{{{axis_y, axis_z, axis_x, true},
                                              {axis_y, axis_z, axis_x, false},
                                              {axis_x, axis_z, axis_y, true},
                                              {axis_x, axis_z, axis_y, false},
                                              {axis_x, axis_y, axis_z, true},
                                              {axis_x, axis_y, axis_z, false}}};

/// The six directions for a cell: those of its sides if it is an upright box in any position, or nearly so
/// [Durand00, 2.4]; otherwise those along the axes. A choice.
std::array<Frame, 6> frames_of(ViewCell const& cell);

}  // namespace visibility::extended_projection
