#include "line_space/portal_families.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"

#include "visibility/line_space/plan_order.hpp"
#include "visibility/line_space/portal_decision.hpp"
#include "visibility/line_space/portal_half_spaces.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

using R = RationalNumber;

Point3q between(Point3d const& a, Point3d const& b, R const& t)
{
  Point3q const p = exact(a), q = exact(b);
  return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
}

/// Whether the line from s on the source to t on the target meets all conditions, straight from their meaning.
bool is_sight_line(PortalSequence const& q, R const& s, R const& t)
{
  Point3q const a = between(q.source.left, q.source.right, s), b = between(q.target.left, q.target.right, t);
  for (auto const& x : q.points) {
    Sign const side = orient2d<Rational>(horizontal(a), horizontal(b), Point2q{R(x.point.x), R(x.point.y)});
    if (side != (x.side == PortalSequence::Side::left ? Sign::positive : Sign::negative)) return false;
  }
  return std::ranges::all_of(q.occluders, [&](PortalSequence::Edge const& f) {
    return is_positive(orient3d<Rational>(a, b, exact(f.right), exact(f.left)));
  });
}

/// Whether all occluders lie between source and target: only then may a sight line be raised to join the two edges.
/// (Behind the source that lowers it: a line that falls over an occluder there and passes below the source has no
/// counterpart from edge to edge.)
bool is_in_order(PortalSequence const& q)
{
  auto const gate = [](PortalSequence::Edge const& e) { return PlanGate{horizontal(e.left), horizontal(e.right)}; };
  return std::ranges::all_of(q.occluders, [&](PortalSequence::Edge const& f) {
    return plan_order<Filtered>(gate(q.source), gate(f)) == PlanOrder::after &&
           plan_order<Filtered>(gate(q.target), gate(f)) == PlanOrder::before;
  });
}

/// Adds the condition that the target is crossed at t, but for a hair: between t - e and t + e.
PortalSequence at_target(PortalSequence q, R const& t, R const& e)
{
  auto const at = [&](R const& x) {
    Point3q const p = between(q.target.left, q.target.right, x);
    return horizontal(p);
  };
  q.constructed_points.push_back({at(t - e), PortalSequence::Side::left});
  q.constructed_points.push_back({at(t + e), PortalSequence::Side::right});
  return q;
}

}  // namespace

TEST_CASE("portal decision: agrees with the Pluecker cone", "[line_space][oracle]")
{
  for (auto const family : all_portal_families) {
    int visible = 0, hidden = 0;
    PortalSource source(family, 77);
    for (int i = 0; i < trials(400); ++i) {
      CAPTURE(name(family), i);
      auto const q = source.sequence(i % 5);
      PortalDecision<ExactNumber> const decision(q);
      bool const exists = decision.exists();
      if (is_in_order(q)) CHECK(exists == has_sight_line<ExactNumber>(q));
      CHECK(PortalDecision<RationalNumber>(q).exists() == exists);
      CHECK(decision.target_parts().empty() == !exists);
      auto const line = decision.find();
      REQUIRE(line.has_value() == exists);
      if (line) CHECK(is_sight_line(q, line->source, line->target));
      ++(exists ? visible : hidden);
    }
    CAPTURE(name(family), visible, hidden);
    CHECK(visible > trials(20));
    CHECK(hidden > trials(20));
  }
}

TEST_CASE("portal decision: the order of occluders and points does not matter, nor do repeated ones",
          "[line_space][law]")
{
  for (auto const family : all_portal_families) {
    PortalSource source(family, 78);
    for (int i = 0; i < trials(100); ++i) {
      auto const q = source.sequence(3);
      auto shuffled = q;
      for (std::size_t k = shuffled.points.size(); k > 1; --k)
        std::swap(shuffled.points[k - 1], shuffled.points[static_cast<std::size_t>(source.random().below(int(k)))]);
      std::ranges::reverse(shuffled.occluders);
      shuffled.occluders.push_back(q.occluders.front());
      CHECK(PortalDecision<ExactNumber>(q).exists() == PortalDecision<ExactNumber>(shuffled).exists());
    }
  }
}

TEST_CASE("portal decision: the parts of the target are where it is seen", "[line_space][oracle]")
{
  int inside = 0, outside = 0;
  for (auto const family : all_portal_families) {
    PortalSource source(family, 79);
    for (int i = 0; i < trials(40); ++i) {
      auto const q = source.sequence(2);
      auto const parts = PortalDecision<RationalNumber>(q).target_parts();
      for (int k = 1; k < 16; ++k) {
        CAPTURE(name(family), i, k);
        R const t(k, 16), hair(1, 1 << 30);
        auto const low = QuadraticNumber<R>::fraction(t - hair, 1), high = QuadraticNumber<R>::fraction(t + hair, 1);
        bool const meets = std::ranges::any_of(parts.intervals(), [&](auto const& p) {
          return is_negative(compare(p.low, high)) && is_positive(compare(p.high, low));
        });
        CHECK(PortalDecision<RationalNumber>(at_target(q, t, hair)).exists() == meets);
        CHECK(PortalDecision<ExactNumber>(at_target(q, R(k, 17), hair)).exists() ==
              PortalDecision<RationalNumber>(at_target(q, R(k, 17), hair)).exists());
        ++(meets ? inside : outside);
      }
    }
  }
  CHECK(inside > trials(100));
  CHECK(outside > trials(100));
}

TEST_CASE("portal decision: a constructed target is like any other", "[line_space][oracle]")
{
  for (auto const family : all_portal_families) {
    PortalSource source(family, 80);
    for (int i = 0; i < trials(60); ++i) {
      CAPTURE(name(family), i);
      auto const whole = source.sequence(i % 4);
      auto part = whole;
      R const low(source.random().between(0, 6), 7), high = low + R(1, 11);
      part.constructed_target = {between(whole.target.left, whole.target.right, low),
                                 between(whole.target.left, whole.target.right, high)};
      auto within = whole;
      for (auto const& [t, side] :
           {std::pair(low, PortalSequence::Side::left), std::pair(high, PortalSequence::Side::right)})
        within.constructed_points.push_back({horizontal(between(whole.target.left, whole.target.right, t)), side});
      PortalDecision<ExactNumber> const decision(part);
      CHECK(decision.exists() == PortalDecision<RationalNumber>(part).exists());
      CHECK(decision.exists() == PortalDecision<ExactNumber>(within).exists());
      if (auto const line = decision.find())
        CHECK(is_sight_line(whole, line->source, low + line->target * (high - low)));
    }
  }
}

TEST_CASE("quadratic numbers: comparison agrees with bisection in rationals", "[line_space][oracle]")
{
  Random random(5);
  for (int i = 0; i < trials(2000); ++i) {
    auto const number = [&] { return R(random.between(-9, 9)); };
    auto const x = real_roots(number(), number(), R(random.between(1, 9)));
    auto const y = real_roots(number(), number(), R(random.between(1, 9)));
    if (!x.first || !y.first) continue;
    auto const value = [](QuadraticNumber<R> const& n) {
      return (CGAL::to_double(n.p) + CGAL::to_double(n.q) * std::sqrt(CGAL::to_double(n.d))) / CGAL::to_double(n.r);
    };
    double const difference = value(*x.first) - value(*y.first);
    Sign const sign = compare(*x.first, *y.first);
    CHECK(sign == -compare(*y.first, *x.first));
    if (std::fabs(difference) > 1e-9)
      CHECK(sign == sign_of(difference));
    else
      CHECK(is_zero(sign));  // small coefficients keep different roots apart
    CHECK(is_zero(compare(*x.first, *x.first)));
  }
}
