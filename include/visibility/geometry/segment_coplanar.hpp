#pragma once

#include "visibility/geometry/segment_end.hpp"
#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <array>

/// The degenerate cases of segment against triangle: everything in one plane, or a triangle that is a segment or point.
namespace visibility::detail {

template <class NT>
bool lexicographically_less(Point3<NT> const& a, Point3<NT> const& b)
{
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

/// The point without coordinate `axis`.
template <class NT>
Point2<NT> drop(int axis, Point3<NT> const& p)
{
  if (axis == 0) return {p.y, p.z};
  if (axis == 1) return {p.x, p.z};
  return {p.x, p.y};
}

/// A coordinate whose removal keeps a, b, c non-collinear; -1 iff they are collinear.
template <Arithmetic A, class NT>
int projection_axis(Point3<NT> const& a, Point3<NT> const& b, Point3<NT> const& c)
{
  for (int axis = 2; axis >= 0; --axis)
    if (!is_zero(orient2d<A>(drop(axis, a), drop(axis, b), drop(axis, c)))) return axis;
  return -1;
}

/// Points of one line: whether the segment from p to q meets [u, v], u <= v lexicographically. Requires: p != q.
template <End end, class NT>
bool collinear_segments_meet(Point3<NT> const& p, Point3<NT> const& q, Point3<NT> const& u, Point3<NT> const& v)
{
  auto const less = lexicographically_less<NT>;
  bool const ends_before = less(p, q) ? less(q, u) : less(v, q);
  bool const ends_at = q == (less(p, q) ? u : v);
  bool const starts_after = less(p, q) ? less(v, p) : less(p, u);
  return !starts_after && !ends_before && !(end == End::excluded && ends_at);
}

/// Whether the segment from p to q meets the segment [u, v], u <= v lexicographically, u == v allowed.
template <Arithmetic A, End end, class NT>
bool segments_meet(Point3<NT> const& p, Point3<NT> const& q, Point3<NT> const& u, Point3<NT> const& v)
{
  int axis = projection_axis<A>(p, q, u);
  if (axis < 0) axis = projection_axis<A>(p, q, v);
  if (axis < 0) return collinear_segments_meet<end>(p, q, u, v);
  if (!is_zero(orient3d<A>(p, q, u, v))) return false;
  auto const P = drop(axis, p), Q = drop(axis, q), U = drop(axis, u), V = drop(axis, v);
  Sign const su = orient2d<A>(P, Q, U), sv = orient2d<A>(P, Q, V);
  if (su == sv) return false;  // not both zero: p, q, u, v span the projected plane
  Sign const sp = orient2d<A>(U, V, P), sq = orient2d<A>(U, V, Q);
  if (end == End::excluded && is_zero(sq)) return false;
  return sp != sq;
}

/// p, q, a, b, c coplanar, in any position. Requires: p != q.
template <Arithmetic A, End end, class NT>
bool coplanar_segment_meets_triangle(Point3<NT> const& a, Point3<NT> const& b, Point3<NT> const& c, Point3<NT> const& p,
                                     Point3<NT> const& q)
{
  int const axis = projection_axis<A>(a, b, c);
  if (axis < 0) {
    auto const [u, v] = std::minmax({a, b, c}, lexicographically_less<NT>);
    return segments_meet<A, end>(p, q, u, v);
  }
  std::array<Point2<NT>, 3> t{drop(axis, a), drop(axis, b), drop(axis, c)};
  if (is_negative(orient2d<A>(t[0], t[1], t[2]))) std::swap(t[1], t[2]);
  auto const P = drop(axis, p), Q = drop(axis, q);
  bool left = false, right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_negative(orient2d<A>(t[i], t[(i + 1) % 3], P))) {
      Sign const s = orient2d<A>(t[i], t[(i + 1) % 3], Q);
      if (is_negative(s) || (end == End::excluded && is_zero(s))) return false;
    }
    Sign const s = orient2d<A>(P, Q, t[i]);
    left |= !is_negative(s);
    right |= !is_positive(s);
  }
  return left && right;
}

}  // namespace visibility::detail
