#include "predicate_checks.hpp"
#include "visibility/predicates/line_ball.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

double some_radius(PointSource& s, Point3d const& p, Point3d const& c)
{
  double const r = s.random().chance(0.5) ? std::fabs(p.x - c.x) : std::fabs(c.y);
  return std::isfinite(r) ? r : 1.0;
}

}  // namespace

TEST_CASE("line_ball: Filtered equals Rational, and every layer that speaks is right",
          "[predicates][agreement][degenerate]")
{
  auto outcomes = check_agreement(detail::LineBallFormula{}, [](PointSource& s) {
    auto const [p, q, c] = s.tuple<3>();
    return std::tuple(p.x, p.y, p.z, q.x, q.y, q.z, c.x, c.y, c.z, some_radius(s, p, c));
  });
  REQUIRE(outcomes[Recipe::uniform].layers.filter > 0.99 * double(outcomes[Recipe::uniform].layers.total()));
  REQUIRE(outcomes[Recipe::grid].signs[1] > 0);
  REQUIRE(outcomes[Recipe::coincident].signs[1] > 0);
  REQUIRE(outcomes[Recipe::huge].layers.exact > 0);
}

TEST_CASE("along: Filtered equals Rational, and every layer that speaks is right",
          "[predicates][agreement][degenerate]")
{
  auto outcomes = check_agreement(detail::AlongFormula{}, [](PointSource& s) {
    auto const [p, q, c] = s.tuple<3>();
    return std::tuple(p.x, p.y, p.z, q.x, q.y, q.z, c.x, c.y, c.z);
  });
  REQUIRE(outcomes[Recipe::grid].signs[1] > 0);
  REQUIRE(outcomes[Recipe::huge].layers.exact > 0);
}

TEST_CASE("line_ball: a tangent line is tangent, one unit in the last place of the radius decides",
          "[predicates][degenerate][layer]")
{
  Random random(30);
  ThreadTally::reset();
  for (int i = 0; i < trials(3000); ++i) {
    // the tangent point is c + k (2, 3, 6); (3, -2, 0) and (3, 0, -1) span the tangent plane
    double const k = double(1 + (random.bits() >> 40)), r = 7 * k;
    Point3d const c{double(random.below(1 << 20)), double(random.below(1 << 20)), double(random.below(1 << 20))};
    int const a = random.between(-99999, 99999), b = random.between(-99999, 99999), s = random.between(-9, 0),
              t = random.between(1, 9);
    if (a == 0 && b == 0) continue;
    auto const at = [&](double m) {
      return Point3d{c.x + 2 * k + m * (3 * a + 3 * b), c.y + 3 * k - m * (2 * a), c.z + 6 * k - m * b};
    };
    CAPTURE(i, k, a, b);
    REQUIRE(line_ball<TalliedFiltered>(at(s), at(t), c, r) == Sign::zero);
    REQUIRE(line_ball<Rational>(at(s), at(t), c, r) == Sign::zero);
    REQUIRE(line_ball<TalliedFiltered>(at(s), at(t), c, std::nextafter(r, HUGE_VAL)) == Sign::positive);
    REQUIRE(line_ball<TalliedFiltered>(at(s), at(t), c, std::nextafter(r, 0)) == Sign::negative);
  }
  REQUIRE(ThreadTally::counts.exact > 0);
}

TEST_CASE("line_ball: exchanging the two points keeps the sign", "[predicates][law]")
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 31);
    for (int i = 0; i < trials(100); ++i) {
      auto const [p, q, c] = source.tuple<3>();
      double const r = some_radius(source, p, c);
      REQUIRE(line_ball<Filtered>(p, q, c, r) == line_ball<Filtered>(q, p, c, r));
    }
  }
}

TEST_CASE("line_ball: a known input is decided by the layer that is meant for it", "[predicates][layer]")
{
  auto const layer = [](Point3d p, Point3d q, Point3d c, double r, Sign sign) {
    return deciding_layer([&] { REQUIRE(line_ball<TalliedFiltered>(p, q, c, r) == sign); });
  };
  CHECK(layer({-5, 0, 0}, {5, 0, 0}, {0, 0.5, 0}, 1, Sign::positive) == Layer::filter);
  CHECK(layer({-5, 0, 0}, {5, 0, 0}, {0, 2, 0}, 1, Sign::negative) == Layer::filter);
  CHECK(layer({1, 2, 3}, {1, 2, 3}, {0, 2, 0}, 1, Sign::zero) == Layer::filter);  // p == q
  CHECK(layer({-5, 0, 0}, {5, 0, 0}, {0, 1, 0}, 1, Sign::zero) <= Layer::interval);
  CHECK(layer({-1e200, 0, 0}, {1e200, 0, 0}, {0, 1, 0}, 1, Sign::zero) == Layer::exact);
}
