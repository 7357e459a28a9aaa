#pragma once

#include "visibility/geometry/ball.hpp"
#include "visibility/geometry/convex_polyhedron.hpp"
#include "visibility/geometry/convex_prism.hpp"
#include "visibility/geometry/segment_end.hpp"
#include "visibility/geometry/triangle.hpp"
#include "visibility/kernel/point.hpp"

#include <algorithm>

/// Whether a segment meets a body, the other way: clip the parameter interval of x(t) = p + t (q - p) in rationals
/// (Liang-Barsky for boxes, Cyrus-Beck for polytopes, the quadratic for balls). Shares no code with the library.
namespace visibility::test::oracle {

using NT = RationalNumber;
struct Vec {
  NT x, y, z;
};
inline Vec vec(Point3d const& p) { return {NT(p.x), NT(p.y), NT(p.z)}; }
inline Vec minus(Vec const& a, Vec const& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline NT dot(Vec const& a, Vec const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec const& a, Vec const& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The parameters t of [0, 1] that satisfy some linear inequalities.
class Clip {
public:
  Clip(Point3d const& p, Point3d const& q) : p_(vec(p)), d_(minus(vec(q), vec(p))) {}

  /// Keeps the t with n.(x(t) - a) <= 0.
  void below(Vec const& n, Vec const& a)
  {
    NT const value = dot(n, minus(p_, a)), slope = dot(n, d_);
    if (slope == 0) {
      if (value > 0) empty_ = true;
    } else if (slope > 0) {
      last_ = std::min<NT>(last_, -value / slope);
    } else {
      first_ = std::max<NT>(first_, -value / slope);
    }
  }
  void on(Vec const& n, Vec const& a)
  {
    below(n, a);
    below({-n.x, -n.y, -n.z}, a);
  }
  bool some(End end) const { return !empty_ && first_ <= last_ && (end == End::included || first_ < 1); }

private:
  Vec p_, d_;
  NT first_ = 0, last_ = 1;
  bool empty_ = false;
};

inline bool meets(Box const& b, Point3d const& p, Point3d const& q, End end)
{
  Clip clip(p, q);
  for (Vec const& n : {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}}) {
    clip.below(n, vec(b.max));
    clip.below({-n.x, -n.y, -n.z}, vec(b.min));
  }
  return clip.some(end);
}

inline bool meets(ConvexPolyhedron const& body, Point3d const& p, Point3d const& q, End end)
{
  Clip clip(p, q);
  for (auto const& f : body.facets) {
    Vec const a = vec(body.vertices[f.vertices[0]]), b = vec(body.vertices[f.vertices[1]]),
              c = vec(body.vertices[f.vertices[2]]);
    clip.below(cross(minus(b, a), minus(c, a)), a);
  }
  return clip.some(end);
}

inline bool meets(ConvexPrism const& prism, Point3d const& p, Point3d const& q, End end)
{
  Clip clip(p, q);
  clip.below({0, 0, 1}, {0, 0, NT(prism.top)});
  clip.below({0, 0, -1}, {0, 0, NT(prism.bottom)});
  for (std::size_t i = 0, n = prism.footprint.size(); i < n; ++i) {
    auto const &a = prism.footprint[i], &b = prism.footprint[(i + 1) % n];
    clip.below({NT(b.y) - NT(a.y), NT(a.x) - NT(b.x), 0}, {NT(a.x), NT(a.y), 0});
  }
  return clip.some(end);
}

inline bool meets(Triangle const& t, Point3d const& p, Point3d const& q, End end)
{
  Vec const v[3] = {vec(t.vertices[0]), vec(t.vertices[1]), vec(t.vertices[2])};
  Vec const n = cross(minus(v[1], v[0]), minus(v[2], v[0]));
  Clip clip(p, q);
  if (dot(n, n) != 0) {
    clip.on(n, v[0]);
    for (int i = 0; i < 3; ++i) clip.below(cross(minus(v[(i + 1) % 3], v[i]), n), v[i]);
    return clip.some(end);
  }
  // A segment or a point: the longest edge contains the others.
  int longest = 0;
  auto const edge = [&](int i) { return minus(v[(i + 1) % 3], v[i]); };
  for (int i = 1; i < 3; ++i)
    if (dot(edge(i), edge(i)) > dot(edge(longest), edge(longest))) longest = i;
  Vec const e = edge(longest);
  for (Vec const& axis : {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}})
    clip.on(dot(e, e) == 0 ? axis : cross(axis, e), v[longest]);
  clip.below({-e.x, -e.y, -e.z}, v[longest]);
  clip.below(e, v[(longest + 1) % 3]);
  return clip.some(end);
}

/// |x(t) - c|^2 - r^2 is convex in t: look at its minimum over the interval.
inline bool meets(Ball const& ball, Point3d const& p, Point3d const& q, End end)
{
  Vec const o = minus(vec(p), vec(ball.centre)), d = minus(vec(q), vec(p));
  NT const a = dot(d, d), b = dot(o, d), c = dot(o, o) - NT(ball.radius) * NT(ball.radius);
  auto const f = [&](NT const& t) -> NT { return (a * t + 2 * b) * t + c; };
  NT const lowest = -b / a;
  if (lowest <= 0) return c <= 0;
  if (lowest < 1) return f(lowest) <= 0;
  return end == End::included ? f(1) <= 0 : f(1) < 0 || c <= 0;
}

}  // namespace visibility::test::oracle
