#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/methods/ray_space/vertical_slice.hpp"

#include <vector>

namespace visibility::ray_space {

/// A point as a family of directions sees it: u forward and v sideways from the middle of the cell, z above its bottom.
/// Each coordinate is one rounded difference: its relative error is at most 2^-53.
struct LocalPoint {
  double u, v, z;
};

/// A closed rectangle of lines v = s + t u.
struct Pixel {
  double s0, s1, t0, t1;
};

/// One of the four families of horizontal directions from a box-shaped cell, and its pixels.
///
/// The family of +x holds the lines v = s + t u that run forward within the diagonals of the cell, |t| <= h / a, where
/// the cell is |u| <= a, |v| <= h; those that meet the cell have |s| <= h + |t| a. So s is where a line crosses the
/// middle of the cell, t where it meets an outer rectangle at infinity; the four families hold every direction. A
/// pixel is a closed rectangle of (s, t), rows in t and columns in s.
/// Source: [Leyvand03, section 2], with the outer square at infinity; proofs/ray_space.md.
class Frame {
public:
  /// Requires: in_domain(cell), 0 <= family < 4, rows and columns positive.
  Frame(Box const& cell, int family, int rows, int columns);

  /// Whether nothing in the proofs overflows or underflows: sides from 2^-100 to 2^100, corners up to 2^100.
  static bool in_domain(Box const& cell);
  static constexpr double reach = 0x1p150;  ///< local coordinates beyond this are out of the domain

  LocalPoint local(Point3d const& p) const
  {
    return {sign_ * (p.*forward_ - centre_.*forward_), p.*sideways_ - centre_.*sideways_, p.z - bottom_};
  }

  int rows() const { return static_cast<int>(t_.size()) - 1; }
  int columns() const { return static_cast<int>(s_.size()) - 1; }
  double s(int column_line) const { return s_[static_cast<std::size_t>(column_line)]; }
  double t(int row_line) const { return t_[static_cast<std::size_t>(row_line)]; }
  double half_length() const { return a_; }  ///< of the cell, forward; rounded up
  double half_width() const { return h_; }   ///< of the cell, sideways; rounded up
  double height() const { return height_; }  ///< of the cell; rounded up

  /// The number of columns that lie wholly in s <= limit; the first column of those wholly in s >= limit.
  int columns_below(double limit) const;
  int columns_from(double limit) const;

  /// The lines of a pixel of the frame.
  Pixel pixel(int row, int column) const { return {s(column), s(column + 1), t(row), t(row + 1)}; }

  /// A rectangle that contains the cell's slice for every line of the pixel; empty, u_in > u_out, if no line of it
  /// meets the cell. Requires: the pixel lies in one of the frame's.
  CellSlice cell_slice(Pixel const& pixel) const;

  /// The same for a pixel of the frame, kept; null if no line of it meets the cell.
  CellSlice const* cell_slice(int row, int column) const
  {
    auto const& k = slices_[static_cast<std::size_t>(row) * (s_.size() - 1) + static_cast<std::size_t>(column)];
    return k.u_in <= k.u_out ? &k : nullptr;
  }

  /// The column lines, and for each pixel of a row how far forward its lines have left the cell at the latest: infinity
  /// if none meets it.
  double const* column_lines() const { return s_.data(); }
  double const* exits(int row) const { return &exits_[static_cast<std::size_t>(row) * (s_.size() - 1)]; }

  /// What |s + t u - v| may be off by for a local point, over the whole map; 8 times it is asked for (the proof says
  /// why that is enough).
  double margin(LocalPoint const& p) const
  {
    return 0x1p-46 * (s_.back() + t_.back() * std::fabs(p.u) + std::fabs(p.v));
  }

private:
  double Point3d::*forward_;
  double Point3d::*sideways_;
  double sign_;
  Point3d centre_;
  double bottom_, a_, h_, height_, columns_per_unit_;
  std::vector<double> s_, t_, exits_;
  std::vector<CellSlice> slices_;
};

}  // namespace visibility::ray_space
