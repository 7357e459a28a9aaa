#pragma once

#include "visibility/kernel/enclosed_rational.hpp"
#include "visibility/line_space/plan_order.hpp"
#include "visibility/methods/exact_25d/crossed_edge.hpp"
#include "visibility/predicates/orient3d.hpp"
#include "visibility/scene/view_cell.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <span>
#include <type_traits>

namespace visibility::exact_25d {

/// Holds sight lines against all top edges of a scene. Exact, with doubles or rationals as ends of the line.
template <Arithmetic A>
class SceneShot {
public:
  /// Keeps references. `ignored`: ascending edges that stop nothing.
  SceneShot(HeightField const& field, ViewCell const& cell, std::span<std::uint32_t const> ignored)
    : field_(field), cell_(cell), ignored_(ignored)
  {
  }

  /// An edge that stops the sight line from p towards q before it crosses the target, or touches it where it passes
  /// over an end of the edge; of several, one that rises high as seen from p. Collinear edges do not stop it. Requires:
  /// p -> q crosses the target in plan.
  template <class NT>
  std::optional<CrossedEdge> first_blocker(Point3<NT> const& p, Point3<NT> const& q, CrossedEdge const& target) const
  {
    return first_blocker(p, q, portal(field_, target));
  }

  /// The same with any edge as target.
  template <class NT>
  std::optional<CrossedEdge> first_blocker(Point3<NT> const& p, Point3<NT> const& q,
                                           PortalSequence::Edge const& target) const
  {
    return highest(p, q, [&](std::uint32_t, PortalSequence::Edge const& f) {
      switch (plan_order<A>(gate(target), gate(f))) {
      case PlanOrder::before: return true;
      case PlanOrder::after:
      case PlanOrder::collinear: break;
      case PlanOrder::crossing: return position(p, q, f) < position(p, q, target);
      }
      return false;
    });
  }

  /// The same with a point of the line in plan as target.
  template <class NT>
  std::optional<CrossedEdge> first_blocker_before(Point3<NT> const& p, Point3<NT> const& q, Point3<NT> const& end) const
  {
    using R = RationalNumber;
    if (p.x == q.x && p.y == q.y) return {};  // rounded ends
    bool const along_x = p.x != q.x;
    R const last = along_x ? R((R(end.x) - R(p.x)) / (R(q.x) - R(p.x))) : R((R(end.y) - R(p.y)) / (R(q.y) - R(p.y)));
    return highest(p, q, [&](std::uint32_t, PortalSequence::Edge const& f) { return position(p, q, f) < last; });
  }

  /// The same for what is crossed before the end of the segment.
  template <class NT>
  std::optional<CrossedEdge> first_blocker(Point3<NT> const& p, Point3<NT> const& q) const
  {
    using Exactness = std::conditional_t<std::same_as<NT, double>, A, Rational>;
    return highest(p, q, [&](std::uint32_t, PortalSequence::Edge const& f) {
      auto const left = visibility::detail::as<NT>(f.left), right = visibility::detail::as<NT>(f.right);
      return is_positive(orient2d<Exactness>(horizontal(left), horizontal(right), horizontal(q)));
    });
  }

private:
  using Edge = PortalSequence::Edge;

  /// The parameter along p -> q at which it crosses the line of an edge in plan; 0 if it is parallel, with rounded
  /// ends.
  template <class NT>
  static RationalNumber position(Point3<NT> const& p, Point3<NT> const& q, Edge const& e)
  {
    using R = RationalNumber;
    auto const side = [&](Point3<NT> const& x) {
      return R(
        visibility::detail::Orient2dFormula{}(R(e.left.x), R(e.left.y), R(e.right.x), R(e.right.y), R(x.x), R(x.y)));
    };
    R const at_p = side(p), width = at_p - side(q);
    return width == 0 ? R(0) : R(at_p / width);
  }

  template <class NT, class IsBefore>
  std::optional<CrossedEdge> highest(Point3<NT> const& p, Point3<NT> const& q, IsBefore const& is_before) const;
  template <class Exactness, class NT>
  std::optional<CrossedEdge> stops(std::uint32_t edge, Point3<NT> const& p, Point3<NT> const& q) const;

  HeightField const& field_;
  ViewCell const& cell_;
  std::span<std::uint32_t const> ignored_;
};

template <Arithmetic A>
template <class Exactness, class NT>
std::optional<CrossedEdge> SceneShot<A>::stops(std::uint32_t edge, Point3<NT> const& p, Point3<NT> const& q) const
{
  auto const& top = field_.edges()[edge];
  auto const a = visibility::detail::as<NT>(top.a), b = visibility::detail::as<NT>(top.b);
  Sign const side_a = orient2d<Exactness>(horizontal(p), horizontal(q), horizontal(a));
  Sign const side_b = orient2d<Exactness>(horizontal(p), horizontal(q), horizontal(b));
  if (side_a == side_b) return {};  // passed on one side, or along the edge
  bool const from_left = is_positive(side_b) || is_negative(side_a);
  auto const &left = from_left ? b : a, &right = from_left ? a : b;
  // Ahead of the eye: the eye lies behind the edge.
  if (!is_negative(orient2d<Exactness>(horizontal(left), horizontal(right), horizontal(p)))) return {};
  if (is_positive(orient3d<Exactness>(p, q, right, left))) return {};
  return CrossedEdge{edge, from_left};
}

template <Arithmetic A>
template <class NT, class IsBefore>
std::optional<CrossedEdge> SceneShot<A>::highest(Point3<NT> const& p, Point3<NT> const& q,
                                                 IsBefore const& is_before) const
{
  // Rational ends are enclosed by doubles once; only the reference takes them as they are.
  constexpr bool is_plain = std::same_as<NT, double> || std::same_as<A, Rational>;
  using Exactness =
    std::conditional_t<std::same_as<NT, double>, A, std::conditional_t<is_plain, Rational, FilteredRational>>;
  using Coordinate = std::conditional_t<is_plain, NT, EnclosedRational>;
  Point3<Coordinate> const eye{p.x, p.y, p.z}, end{q.x, q.y, q.z};
  Point3d const from = visibility::detail::rounded(p);
  EnclosingProbe const probe(p, q);
  std::optional<CrossedEdge> best;
  double steepest = 0;
  field_.edge_hierarchy().front_to_back(
    cell_.bounds(), [&](std::uint32_t, Box const& b) { return !probe.certainly_misses(b); },
    [&](std::uint32_t i) {
      if (std::ranges::binary_search(ignored_, i)) return;
      auto const blocker = stops<Exactness>(i, eye, end);
      if (!blocker) return;
      auto const& e = field_.edges()[i];
      double const x = (e.a.x + e.b.x) / 2 - from.x, y = (e.a.y + e.b.y) / 2 - from.y;
      double const slope = (std::max(e.a.z, e.b.z) - from.z) / std::hypot(x, y);
      if ((best && slope <= steepest) || !is_before(i, portal(e, blocker->from_left))) return;
      steepest = slope;
      best = blocker;
    });
  return best;
}

}  // namespace visibility::exact_25d
