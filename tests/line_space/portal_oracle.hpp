#pragma once

#include "portal_families.hpp"

#include "visibility/predicates/line_side.hpp"
#include "visibility/predicates/orient2d.hpp"

#include <optional>

/// Portal sequences decided without Plücker coordinates: a line by its points and the predicates; the best line over
/// one plan line, in the slice above it, by similar triangles.
namespace visibility::test {

/// Whether the line from p to q is a sight line of the sequence: side by side, exactly.
inline bool is_sight_line(PortalSequence const& s, Point3q const& p, Point3q const& q)
{
  auto const above = [&](PortalSequence::Edge const& e) {
    return line_side<Rational>(p, q, exact(e.right), exact(e.left));
  };
  if (!is_negative(above(s.source)) || !is_negative(above(s.target))) return false;
  for (auto const& f : s.occluders)
    if (!is_positive(above(f))) return false;
  for (auto const& [x, side] : s.points) {
    Sign const left =
      orient2d<Rational>(horizontal(p), horizontal(q), Point2q{RationalNumber(x.x), RationalNumber(x.y)});
    if (left != (side == PortalSequence::Side::left ? Sign::positive : Sign::negative)) return false;
  }
  return true;
}

/// The point of the edge above the plan line from p to q; none where they are parallel.
inline std::optional<Point3q> crossing(PortalSequence::Edge const& e, Point2q const& p, Point2q const& q)
{
  auto const side = [&](Point3d const& x) -> RationalNumber {
    return (q.x - p.x) * (RationalNumber(x.y) - p.y) - (q.y - p.y) * (RationalNumber(x.x) - p.x);
  };
  RationalNumber const l = side(e.left), r = side(e.right);
  if (l == r) return {};
  RationalNumber const t = l / (l - r);
  auto const at = [&](double a, double b) -> RationalNumber {
    return RationalNumber(a) + t * (RationalNumber(b) - RationalNumber(a));
  };
  return Point3q{at(e.left.x, e.right.x), at(e.left.y, e.right.y), at(e.left.z, e.right.z)};
}

/// A sight line above the plan line from p to q, if there is one: the line through source and target is the highest,
/// and a little below it is strict. Returned lowered by `drop`.
inline bool some_sight_line_above(PortalSequence const& s, Point2q const& p, Point2q const& q)
{
  for (auto const& [x, side] : s.points) {
    Sign const left = orient2d<Rational>(p, q, Point2q{RationalNumber(x.x), RationalNumber(x.y)});
    if (left != (side == PortalSequence::Side::left ? Sign::positive : Sign::negative)) return false;
  }
  auto const a = crossing(s.source, p, q), b = crossing(s.target, p, q);
  if (!a || !b) return false;
  auto const along = [&](Point3q const& x) -> RationalNumber {
    return (q.x - p.x) * (x.x - p.x) + (q.y - p.y) * (x.y - p.y);
  };
  RationalNumber const from = along(*a), to = along(*b);
  if (from == to) return false;  // one point of the plan: any slope; left to others
  for (auto const& f : s.occluders) {
    auto const c = crossing(f, p, q);
    if (!c) return false;
    RationalNumber const t = (along(*c) - from) / (to - from);
    if (a->z + t * (b->z - a->z) <= c->z) return false;
  }
  return true;
}

/// A plan line through random points of source and target, often close to their ends.
inline std::pair<Point2q, Point2q> random_plan_line(PortalSequence const& s, Random& random)
{
  auto const pick = [&](PortalSequence::Edge const& e) {
    double t = random.unit();
    if (random.chance(0.3)) t = t * t * t * t;
    if (random.chance(0.3)) t = 1 - (1 - t) * (1 - t) * (1 - t) * (1 - t);
    RationalNumber const w(t);
    auto const at = [&](double a, double b) -> RationalNumber {
      return RationalNumber(a) + w * (RationalNumber(b) - RationalNumber(a));
    };
    return Point2q{at(e.left.x, e.right.x), at(e.left.y, e.right.y)};
  };
  return {pick(s.source), pick(s.target)};
}

}  // namespace visibility::test
