#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/methods/extended_projection/options.hpp"
#include "visibility/scene/view_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace visibility::extended_projection {

/// A linear map of space, its rows: by nature a rotation, but any one that is not singular will do. A map that turns
/// the plan only has the row (0, 0, 1): then heights stay as they are.
class Turn {
public:
  constexpr Turn() = default;
  constexpr Turn(Point3d const& x, Point3d const& y, Point3d const& z) : rows_{x, y, z}
  {
    turns_ = !(x == Point3d{1, 0, 0} && y == Point3d{0, 1, 0} && z == Point3d{0, 0, 1});
    keeps_heights_ = z == Point3d{0, 0, 1};
    largest_ = 0;
    for (auto const& r : rows_)
      for (double const e : {r.x, r.y, r.z}) largest_ = std::max({largest_, e, -e});
  }
  /// By an angle about the vertical: x becomes a x + b y, y becomes a y - b x.
  static constexpr Turn of_plan(double a, double b) { return {{a, b, 0}, {-b, a, 0}, {0, 0, 1}}; }

  constexpr bool is_identity() const { return !turns_; }
  constexpr bool keeps_heights() const { return keeps_heights_; }
  std::array<Point3d, 3> const& rows() const { return rows_; }

  /// Rounded; heights that are kept are exact, and so is everything if nothing is turned.
  Point3d operator()(Point3d const& p) const
  {
    if (!turns_) return p;
    return {along(rows_[0], p), along(rows_[1], p), keeps_heights_ ? p.z : along(rows_[2], p)};
  }
  /// How far off a coordinate may be that is not exact: a product and two sums, twice over
  /// (proofs/extended_projection.md, "Frames along turned cells").
  double error(Point3d const& p) const
  {
    if (!turns_) return 0;
    return 0x1p-50 * largest_ * (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z)) + 0x1p-1000;
  }

private:
  static double along(Point3d const& row, Point3d const& p) { return row.x * p.x + row.y * p.y + row.z * p.z; }

  std::array<Point3d, 3> rows_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double largest_ = 1;
  bool turns_ = false, keeps_heights_ = true;
};

/// Coordinates (u, v, w) for one of six directions: w grows along a coordinate axis or against it, u and v are the
/// other two axes, v the third one if w is not. Space may be turned before, so that axes are those of an oriented cell;
/// if it is not, all is exact: coordinates are exchanged and w negated.
/// Points of a frame are Point3d and Box with x = u, y = v, z = w.
struct Frame {
  double Point3d::*u = &Point3d::x;
  double Point3d::*v = &Point3d::y;
  double Point3d::*w = &Point3d::z;
  bool up = true;
  Turn turn{};

  bool is_turned() const { return !turn.is_identity(); }
  bool has_vertical_v() const { return v == &Point3d::z && turn.keeps_heights(); }
  /// How much w grows, about, on the way up by 1.
  double rise() const
  {
    Point3d const in{turn.rows()[0].z, turn.rows()[1].z, turn.rows()[2].z};
    return exchanged(in).z;
  }

  Point3d operator()(Point3d const& p) const { return exchanged(turn(p)); }
  /// How far off u and v may be.
  double error(Point3d const& p) const { return turn.error(p); }
  /// How far off w may be.
  double depth_error(Point3d const& p) const { return w == &Point3d::z && turn.keeps_heights() ? 0 : turn.error(p); }
  /// A box that contains it; the least one, unless turned.
  Box operator()(Box const& box) const;
  /// A box that contains the image of the point.
  Box around(Point3d const& p) const;

private:
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

/// The six directions for a cell: those of its sides if it is a box in any position, upright or tilted, or nearly so
/// [Durand00, 2.4]; otherwise those along the axes. Of a tilted one the third axis is the steepest. A choice.
std::array<Frame, 6> frames_of(ViewCell const& cell);
/// These or those along the axes, as the option says.
std::array<Frame, 6> frames_for(ViewCell const& cell, Directions directions);

}  // namespace visibility::extended_projection
