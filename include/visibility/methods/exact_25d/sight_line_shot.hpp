#pragma once

#include "visibility/line_space/cell_outline.hpp"
#include "visibility/line_space/plan_order.hpp"
#include "visibility/predicates/orient3d.hpp"
#include "visibility/scene/height_field.hpp"

#include <optional>

namespace visibility::exact_25d {

/// An edge as sight lines cross it: from the right of a -> b (into its column), or from the left.
struct CrossedEdge {
  std::uint32_t edge;
  bool from_left;
  friend bool operator==(CrossedEdge const&, CrossedEdge const&) = default;
};

inline PortalSequence::Edge portal(HeightField::TopEdge const& e, bool from_left)
{
  return from_left ? PortalSequence::Edge{e.b, e.a} : PortalSequence::Edge{e.a, e.b};
}
inline PortalSequence::Edge portal(HeightField const& field, CrossedEdge const& c)
{
  return portal(field.edges()[c.edge], c.from_left);
}

template <class NT>
Point3<NT> as(Point3d const& p)
{
  return {NT(p.x), NT(p.y), NT(p.z)};
}

/// Whether the line through p and q crosses `f` in plan before it crosses `e`. Requires: edges that cross each other in
/// plan, both crossed by the line. Exact for exact numbers.
template <class NT>
bool is_crossed_first(Point3<NT> const& p, Point3<NT> const& q, PortalSequence::Edge const& e,
                      PortalSequence::Edge const& f)
{
  // The parameter along p -> q at which the line of an edge is met: n / (n - m) with the sides of p and q.
  auto const parameter = [&](PortalSequence::Edge const& g) {
    auto const side = [&](Point3<NT> const& x) {
      return RationalNumber(detail::Orient2dFormula{}(RationalNumber(g.left.x), RationalNumber(g.left.y),
                                                      RationalNumber(g.right.x), RationalNumber(g.right.y),
                                                      RationalNumber(x.x), RationalNumber(x.y)));
    };
    RationalNumber const n = side(p);
    return RationalNumber(n / (n - side(q)));
  };
  return parameter(f) < parameter(e);
}

/// Whether `f` stops the sight line from p towards q before it crosses `target` (or touches it where it passes over an
/// end of f). Requires: p -> q crosses the target's line in plan from behind.
template <Arithmetic A, class NT>
bool stops(Point3<NT> const& p, Point3<NT> const& q, PortalSequence::Edge const& target,
           HeightField::TopEdge const& top)
{
  auto const a = as<NT>(top.a), b = as<NT>(top.b);
  Sign const side_a = orient2d<A>(horizontal(p), horizontal(q), horizontal(a));
  Sign const side_b = orient2d<A>(horizontal(p), horizontal(q), horizontal(b));
  if (side_a == side_b) return false;                                 // passed on one side, or along the edge
  bool const from_left = is_positive(side_b) || is_negative(side_a);  // b on the left: a -> b is crossed from its left
  auto const f = portal(top, from_left);
  auto const left = as<NT>(f.left), right = as<NT>(f.right);
  // Ahead of the eye: the eye lies behind the edge.
  if (!is_negative(orient2d<A>(horizontal(left), horizontal(right), horizontal(p)))) return false;
  switch (plan_order<A>(gate(target), gate(f))) {
  case PlanOrder::before: break;
  case PlanOrder::after:
  case PlanOrder::collinear: return false;
  case PlanOrder::crossing:
    if (!is_crossed_first(p, q, target, f)) return false;
    break;
  }
  return !is_positive(orient3d<A>(p, q, right, left));
}

}  // namespace visibility::exact_25d
