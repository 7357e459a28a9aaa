#pragma once

#include "visibility/methods/strong_occlusion/target.hpp"
#include "visibility/predicates/line_side.hpp"
#include "visibility/scene/view_cell.hpp"

#include <vector>

/// The sight lines that decide for all: along the edges of the convex hull of cell and target that join a vertex of
/// the one to a vertex of the other. A convex body that touches neither cell nor target and meets these meets every
/// sight line (proofs/strong_occlusion.md, Theorem 2).  Source: [CohenOr98, 5, optimization 3].
namespace visibility::strong_occlusion {

/// The sight line [from, to): from a vertex of the cell to a vertex of the target.
struct Ray {
  Point3d from, to;
};

namespace detail {

/// Signs of the coordinates of s (a - b), where s_k = +1 if bit k of the octant is set, else -1.
class OctantSigns {
public:
  OctantSigns(int octant, Point3d const& a, Point3d const& b)
  {
    add((octant & 1) != 0, a.x, b.x);
    add((octant & 2) != 0, a.y, b.y);
    add((octant & 4) != 0, a.z, b.z);
  }
  int zeros() const { return 3 - positive_ - negative_; }
  bool mixed() const { return positive_ > 0 && negative_ > 0; }
  bool none_positive() const { return positive_ == 0; }

private:
  void add(bool up, double a, double b)
  {
    positive_ += up ? a > b : a < b;
    negative_ += up ? a < b : a > b;
  }
  int positive_ = 0, negative_ = 0;
};

/// Corner c of a box is extreme in the directions of one octant only. In them the line cs is on the hull's boundary for
/// some plane only if c - s has both strict signs there, or is parallel to an axis.
inline bool may_be_hull_edge(int octant, Point3d const& c, Point3d const& s)
{
  OctantSigns const d(octant, c, s);
  return d.mixed() || d.zeros() == 2;
}

inline void append_box_to_box(Box const& cell, Box const& target, std::vector<Ray>& out)
{
  // may_be_hull_edge for all octants at once: per axis and side, whether the coordinate is positive or negative there.
  int positive[3][2], negative[3][2];
  int axis = 0;
  for (auto const k : {&Point3d::x, &Point3d::y, &Point3d::z}) {
    positive[axis][0] = cell.min.*k < target.min.*k;
    negative[axis][0] = cell.min.*k > target.min.*k;
    positive[axis][1] = cell.max.*k > target.max.*k;
    negative[axis][1] = cell.max.*k < target.max.*k;
    ++axis;
  }
  for (int i = 0; i < 8; ++i) {
    int const x = i & 1, y = i >> 1 & 1, z = i >> 2;
    int const up = positive[0][x] + positive[1][y] + positive[2][z];
    int const down = negative[0][x] + negative[1][y] + negative[2][z];
    if ((up > 0 && down > 0) || up + down == 1) out.push_back({cell.corner(i), target.corner(i)});
  }
}

inline void append_box_to_any(Box const& cell, std::span<Point3d const> target, std::vector<Ray>& out)
{
  for (int i = 0; i < 8; ++i) {
    Point3d const c = cell.corner(i);
    for (auto const& s : target) {
      // Another vertex further out in every direction of the octant (but for one axis at most) rules s out.
      auto const dominates = [&](Point3d const& other) {
        OctantSigns const e(i, s, other);
        return e.none_positive() && e.zeros() <= 1;
      };
      if (may_be_hull_edge(i, c, s) && std::ranges::none_of(target, dominates)) out.push_back({c, s});
    }
  }
}

/// Whether the line cs certainly passes through the interior of the hull: three other vertices surround it. Which three
/// is a guess in floating point, that they surround it is proved by the sides on which lines pass.
inline bool certainly_inside(std::span<Point3d const> cell, std::span<Point3d const> target, Point3d const& c,
                             Point3d const& s)
{
  auto const minus = [](Point3d const& a, Point3d const& b) { return Point3d{a.x - b.x, a.y - b.y, a.z - b.z}; };
  auto const cross = [](Point3d const& a, Point3d const& b) {
    return Point3d{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  auto const dot = [](Point3d const& a, Point3d const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  Point3d const d = minus(s, c);
  // In the plane across d: the vertex furthest from the line, and the two that lie furthest round to either side of it.
  Point3d const* first = nullptr;
  double furthest = 0;
  auto const each = [&](auto&& use) {
    for (auto const& v : cell) use(v);
    for (auto const& v : target) use(v);
  };
  each([&](Point3d const& v) {
    Point3d const m = cross(d, minus(v, c));
    if (double const distance = dot(m, m); distance > furthest) furthest = distance, first = &v;
  });
  if (first == nullptr) return false;
  Point3d const axis = cross(d, minus(*first, c));
  Point3d const up = cross(axis, d);  // towards `first`
  Point3d const *left = nullptr, *right = nullptr;
  double left_slope = HUGE_VAL, right_slope = HUGE_VAL;  // the cotangent falls as the angle grows
  each([&](Point3d const& v) {
    Point3d const w = minus(v, c);
    double const across = dot(axis, w), along = dot(up, w);
    if (across > 0 && along / across < left_slope) left_slope = along / across, left = &v;
    if (across < 0 && -along / across < right_slope) right_slope = -along / across, right = &v;
  });
  if (left == nullptr || right == nullptr) return false;
  Sign const side = line_side<Filtered>(c, s, *first, *left);
  return !is_zero(side) && line_side<Filtered>(c, s, *left, *right) == side &&
         line_side<Filtered>(c, s, *right, *first) == side;
}

}  // namespace detail

/// Appends the sight lines along hull edges, and perhaps a few more.
/// Requires: cell and target share no point.
inline void append_hull_rays(ViewCell const& cell, Target const& target, std::vector<Ray>& out)
{
  if (cell.is_box() && target.is_box) return detail::append_box_to_box(cell.bounds(), target.bounds, out);
  if (cell.is_box()) return detail::append_box_to_any(cell.bounds(), target.vertices, out);
  for (auto const& c : cell.vertices())
    for (auto const& s : target.vertices)
      if (!detail::certainly_inside(cell.vertices(), target.vertices, c, s)) out.push_back({c, s});
}

}  // namespace visibility::strong_occlusion
