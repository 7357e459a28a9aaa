#include "predicate_checks.hpp"
#include "visibility/predicates/orient2d.hpp"

using namespace visibility;
using namespace visibility::test;

TEST_CASE("orient2d: Filtered equals Rational, and every layer that speaks is right",
          "[predicates][agreement][degenerate]")
{
  auto outcomes = check_agreement(detail::Orient2dFormula{}, [](PointSource& s) {
    auto const [p, q, r] = s.tuple<3>();
    return std::tuple(p.x, p.y, q.x, q.y, r.x, r.y);
  });
  REQUIRE(outcomes[Recipe::uniform].layers.filter > 0.99 * double(outcomes[Recipe::uniform].layers.total()));
  for (Recipe const recipe : {Recipe::collinear, Recipe::nextafter, Recipe::subnormal, Recipe::huge, Recipe::city}) {
    CAPTURE(name(recipe));
    auto const& tally = outcomes[recipe].layers;
    bool const intervals_suffice = recipe == Recipe::city || recipe == Recipe::subnormal;
    REQUIRE((intervals_suffice ? tally.interval + tally.exact : tally.exact) > 0);
  }
  for (Recipe const recipe : {Recipe::grid, Recipe::collinear, Recipe::coincident, Recipe::subnormal, Recipe::huge}) {
    CAPTURE(name(recipe));
    REQUIRE(outcomes[recipe].signs[1] > 0);
  }
}

TEMPLATE_TEST_CASE("orient2d: cyclic shifts keep the sign, a swap flips it", "[predicates][law]", Filtered, Rational)
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 7);
    for (int i = 0; i < trials(200); ++i) {
      auto const t = source.tuple<3>();
      auto const p = horizontal(t[0]), q = horizontal(t[1]), r = horizontal(t[2]);
      Sign const s = orient2d<TestType>(p, q, r);
      REQUIRE(orient2d<TestType>(q, r, p) == s);
      REQUIRE(orient2d<TestType>(r, p, q) == s);
      REQUIRE(orient2d<TestType>(q, p, r) == -s);
      REQUIRE(orient2d<TestType>(p, r, q) == -s);
    }
  }
}

TEST_CASE("orient2d: a known input is decided by the layer that is meant for it", "[predicates][layer]")
{
  auto const layer = [](Point2d p, Point2d q, Point2d r, Sign sign) {
    return deciding_layer([&] { REQUIRE(orient2d<TalliedFiltered>(p, q, r) == sign); });
  };
  CHECK(layer({0, 0}, {1, 0}, {0, 1}, Sign::positive) == Layer::filter);
  CHECK(layer({0, 0}, {0, 1}, {1, 0}, Sign::negative) == Layer::filter);
  CHECK(layer({0.1, 0.7}, {0.2, 0.7}, {0.5, 0.7}, Sign::zero) == Layer::filter);  // one height
  CHECK(layer({0.1, 0.7}, {0.2, 0.9}, {0.1, 0.7}, Sign::zero) == Layer::filter);  // p == r
  CHECK(layer({0.1, 0.7}, {0.1, 0.7}, {0.3, 0.5}, Sign::zero) == Layer::filter);  // p == q
  CHECK(layer({0, 0}, {3, 5}, {6, 10}, Sign::zero) <= Layer::interval);           // exact in double
  CHECK(layer({0.1, 0.1}, {0.2, 0.2}, {0.7, std::nextafter(0.7, 1)}, Sign::positive) >= Layer::interval);
  CHECK(layer({1e308, 1e308}, {-1e308, -1e308}, {0, 1e308}, Sign::negative) == Layer::exact);
  CHECK(layer({0, 0}, {0x1p-1074, 0}, {0, 0x1p-1074}, Sign::positive) >= Layer::interval);
}

TEST_CASE("orient2d: Double gets a nearly collinear turn wrong, Filtered does not", "[predicates][layer]")
{
  // Kettner et al. 2008, figure 1: p walks on a grid of ulps around the line y = x
  int wrong = 0;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      Point2d const p{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}, q{12, 12}, r{24, 24};
      REQUIRE(orient2d<Filtered>(p, q, r) == sign_of(j - i));
      wrong += orient2d<Double>(p, q, r) != sign_of(j - i);
    }
  REQUIRE(wrong > 0);
}
