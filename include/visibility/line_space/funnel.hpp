#pragma once

#include "visibility/predicates/orient2d.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <utility>

namespace visibility {

/// Two plan points by where they lie as seen along a directed line that passes between them.
template <class NT>
struct Gate {
  Point2<NT> left, right;
};
using PlanGate = Gate<double>;

/// A convex polygon of 2D line space with interior: directed lines of the plan, bounded by plan points that lie on one
/// side of them. Every vertex is a line through two input points, so no coordinate is ever constructed. The side of the
/// polygon between two vertices is a pencil of lines through one point, the pivot.
///
/// Invariants: the directions of all lines lie within less than 180 degrees; the pivot of a vertex lies on it and on
/// the next one; consecutive vertices are different lines.
/// Source: line space as in [BWW01] and [Bittner05, §4]; proofs/exact_2_5d.md.
class Funnel {
public:
  /// The line directed from p to q, and the pivot of the side to the next vertex.
  struct Vertex {
    Point2d p, q;
    Point2d pivot;
  };
  using Vertices = boost::container::small_vector<Vertex, 6>;
  /// Where a plan point lies as seen along each vertex: positive is left.
  using Sides = boost::container::small_vector<Sign, 12>;

  Funnel() = default;

  /// The lines that pass first through `entry`, then through `exit`, two different sides of a convex polygon.
  /// Empty if the sides are collinear.
  template <Arithmetic A>
  static Funnel through(PlanGate const& entry, PlanGate const& exit);

  Vertices const& vertices() const { return vertices_; }
  bool empty() const { return vertices_.empty(); }

  template <Arithmetic A>
  Sides sides_of(Point2d const& point) const
  {
    Sides out;
    for (auto const& v : vertices_) out.push_back(orient2d<A>(v.p, v.q, point));
    return out;
  }

  /// The lines of this polygon that have the point on `side`; empty if none does so strictly.
  template <Arithmetic A>
  Funnel with(Point2d const& point, Sign side) const
  {
    return with<A>(point, side, sides_of<A>(point));
  }
  /// The same where the sides are known.
  template <Arithmetic A>
  Funnel with(Point2d const& point, Sign side, Sides const& sides) const;

private:
  template <Arithmetic A>
  static Vertex between(Vertex const& point_left, Vertex const& point_right, Point2d const& pivot,
                        Point2d const& point);

  Vertices vertices_;
};

template <Arithmetic A>
Funnel Funnel::through(PlanGate const& entry, PlanGate const& exit)
{
  Funnel out;
  auto const add = [&](Point2d const& p, Point2d const& q, Point2d const& pivot) {
    if (!(p == q)) out.vertices_.push_back({p, q, pivot});
  };
  add(entry.left, exit.left, entry.left);
  add(entry.left, exit.right, exit.right);
  add(entry.right, exit.right, entry.right);
  add(entry.right, exit.left, exit.left);
  auto const& v = out.vertices_;
  bool const collinear = std::ranges::all_of(v, [&](Vertex const& w) {
    return is_zero(orient2d<A>(v[0].p, v[0].q, w.p)) && is_zero(orient2d<A>(v[0].p, v[0].q, w.q));
  });
  return collinear ? Funnel{} : out;
}

namespace detail {

/// Whether `point` lies strictly ahead of `pivot`, both on the line directed from p to q.
inline bool is_ahead(Point2d const& p, Point2d const& q, Point2d const& pivot, Point2d const& point)
{
  if (p.x != q.x) return q.x > p.x ? point.x > pivot.x : point.x < pivot.x;
  return q.y > p.y ? point.y > pivot.y : point.y < pivot.y;
}

}  // namespace detail

/// The line through the pivot of two consecutive vertices and the point, directed as they are, where the point lies to
/// the left of one and to the right of the other.
template <Arithmetic A>
auto Funnel::between(Vertex const& point_left, Vertex const& point_right, Point2d const& pivot, Point2d const& point)
  -> Vertex
{
  // The point lies ahead of the pivot iff the second line is turned counterclockwise from the first.
  auto const& w = point_right;
  Sign const turn = detail::is_ahead(w.p, w.q, pivot, w.q) ? orient2d<A>(point_left.p, point_left.q, w.q)
                                                           : -orient2d<A>(point_left.p, point_left.q, w.p);
  return is_positive(turn) ? Vertex{pivot, point, {}} : Vertex{point, pivot, {}};
}

template <Arithmetic A>
Funnel Funnel::with(Point2d const& point, Sign side, Sides const& sides) const
{
  Funnel out;
  if (std::ranges::find(sides, side) == sides.end()) return out;
  std::size_t const n = vertices_.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t const j = i + 1 < n ? i + 1 : 0;
    auto const &v = vertices_[i], &w = vertices_[j];
    bool const kept = sides[i] != -side, next_kept = sides[j] != -side;
    auto const add_crossing = [&](Point2d const& pivot) {
      out.vertices_.push_back(is_positive(sides[i]) ? between<A>(v, w, v.pivot, point)
                                                    : between<A>(w, v, v.pivot, point));
      out.vertices_.back().pivot = pivot;
    };
    if (kept) out.vertices_.push_back(v);
    if (kept && !next_kept) {
      // From here the polygon's side turns about the point; a vertex through the point is the crossing itself.
      if (is_zero(sides[i]))
        out.vertices_.back().pivot = point;
      else
        add_crossing(point);
    } else if (!kept && next_kept && !is_zero(sides[j]))
      add_crossing(v.pivot);
  }
  return out;
}

}  // namespace visibility
