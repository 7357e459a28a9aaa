#pragma once

#include "visibility/geometry/box.hpp"

#include <array>
#include <utility>

namespace visibility::extended_projection {

/// Coordinates (u, v, w) for one of six directions: w grows along a coordinate axis or against it, u and v are the
/// other two axes, v the vertical if w is not. Exact: coordinates are exchanged and w negated. Points of a frame are
/// Point3d and Box with x = u, y = v, z = w.
struct Frame {
  double Point3d::*u = &Point3d::x;
  double Point3d::*v = &Point3d::y;
  double Point3d::*w = &Point3d::z;
  bool up = true;

  Point3d operator()(Point3d const& p) const { return {p.*u, p.*v, up ? p.*w : -(p.*w)}; }
  Box operator()(Box const& b) const
  {
    Point3d low = (*this)(b.min), high = (*this)(b.max);
    if (!up) std::swap(low.z, high.z);
    return {low, high};
  }
  bool has_vertical_v() const { return v == &Point3d::z; }
};

inline constexpr double Point3d::*axis_x = &Point3d::x;
inline constexpr double Point3d::*axis_y = &Point3d::y;
inline constexpr double Point3d::*axis_z = &Point3d::z;

/// The six directions.
inline constexpr std::array<Frame, 6> frames{{{axis_y, axis_z, axis_x, true},
                                              {axis_y, axis_z, axis_x, false},
                                              {axis_x, axis_z, axis_y, true},
                                              {axis_x, axis_z, axis_y, false},
                                              {axis_x, axis_y, axis_z, true},
                                              {axis_x, axis_y, axis_z, false}}};

}  // namespace visibility::extended_projection
