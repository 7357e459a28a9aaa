#include "predicate_checks.hpp"
#include "visibility/predicates/in_ball.hpp"

using namespace visibility;
using namespace visibility::test;

TEST_CASE("in_ball: Filtered equals Rational, and every layer that speaks is right",
          "[predicates][agreement][degenerate]")
{
  auto outcomes = check_agreement(detail::InBallFormula{}, [](PointSource& s) {
    auto const [p, c, d] = s.tuple<3>();
    // a radius that is the distance along one axis, or any coordinate
    double const r = s.random().chance(0.5) ? std::fabs(p.x - c.x) : std::fabs(d.y);
    return std::tuple(p.x, p.y, p.z, c.x, c.y, c.z, std::isfinite(r) ? r : 1.0);
  });
  REQUIRE(outcomes[Recipe::uniform].layers.filter > 0.99 * double(outcomes[Recipe::uniform].layers.total()));
  REQUIRE(outcomes[Recipe::grid].signs[1] > 0);
  REQUIRE(outcomes[Recipe::huge].layers.exact > 0);
}

TEST_CASE("in_ball: a Pythagorean point is on the sphere, its neighbours are not", "[predicates][degenerate][layer]")
{
  Random random(20);
  ThreadTally::reset();
  for (int i = 0; i < trials(5000); ++i) {
    // (2, 3, 6) has length 7; 40-bit multiples make every product round
    double const k = double(random.bits() >> 24), r = 7 * k;
    Point3d const c{double(random.below(1 << 20)), double(random.below(1 << 20)), double(random.below(1 << 20))};
    Point3d p{c.x + 2 * k, c.y - 3 * k, c.z + 6 * k};
    CAPTURE(i, k);
    if (k == 0) continue;
    REQUIRE(in_ball<TalliedFiltered>(p, c, r) == Sign::zero);
    REQUIRE(in_ball<TalliedFiltered>({std::nextafter(p.x, HUGE_VAL), p.y, p.z}, c, r) == Sign::negative);
    REQUIRE(in_ball<TalliedFiltered>({p.x, std::nextafter(p.y, HUGE_VAL), p.z}, c, r) == Sign::positive);
    REQUIRE(in_ball<TalliedFiltered>(p, c, std::nextafter(r, HUGE_VAL)) == Sign::positive);
    REQUIRE(in_ball<Rational>(p, c, r) == Sign::zero);
  }
  REQUIRE(ThreadTally::counts.exact > 0);
}

TEST_CASE("in_ball: exchanging the point and the centre keeps the sign", "[predicates][law]")
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 21);
    for (int i = 0; i < trials(200); ++i) {
      auto const [p, c, d] = source.tuple<3>();
      REQUIRE(in_ball<Filtered>(p, c, std::fabs(d.x)) == in_ball<Filtered>(c, p, std::fabs(d.x)));
    }
  }
}

TEST_CASE("in_ball: a known input is decided by the layer that is meant for it", "[predicates][layer]")
{
  auto const layer = [](Point3d p, Point3d c, double r, Sign sign) {
    return deciding_layer([&] { REQUIRE(in_ball<TalliedFiltered>(p, c, r) == sign); });
  };
  CHECK(layer({0, 0, 0}, {0, 0, 0.5}, 1, Sign::positive) == Layer::filter);
  CHECK(layer({0, 0, 3}, {0, 0, 0.5}, 1, Sign::negative) == Layer::filter);
  CHECK(layer({0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}, 0, Sign::zero) == Layer::filter);  // a ball that is a point
  CHECK(layer({0, 0, 3}, {0, 0, 0}, 3, Sign::zero) <= Layer::interval);
  CHECK(layer({1e300, 0, 0}, {-1e300, 0, 0}, 1e300, Sign::negative) == Layer::exact);
  CHECK(layer({0x1p-1074, 0, 0}, {0, 0, 0}, 0, Sign::negative) >= Layer::interval);
}
