#include "predicate_checks.hpp"
#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

using namespace visibility;
using namespace visibility::test;

TEST_CASE("orient3d: Filtered equals Rational, and every layer that speaks is right",
          "[predicates][agreement][degenerate]")
{
  auto outcomes = check_agreement(detail::Orient3dFormula{}, [](PointSource& s) {
    auto const [p, q, r, t] = s.tuple<4>();
    return std::tuple(p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y, r.z, t.x, t.y, t.z);
  });
  REQUIRE(outcomes[Recipe::uniform].layers.filter > 0.99 * double(outcomes[Recipe::uniform].layers.total()));
  for (Recipe const recipe : {Recipe::coplanar, Recipe::collinear, Recipe::nextafter, Recipe::rounded, Recipe::huge}) {
    CAPTURE(name(recipe));
    REQUIRE(outcomes[recipe].layers.exact > 0);
  }
  for (Recipe const recipe : {Recipe::grid, Recipe::coplanar, Recipe::collinear, Recipe::coincident, Recipe::subnormal,
                              Recipe::huge, Recipe::city}) {
    CAPTURE(name(recipe));
    REQUIRE(outcomes[recipe].signs[1] > 0);
  }
  // Shared vertices and equal heights must not need the exact layer.
  REQUIRE(outcomes[Recipe::coincident].layers.exact == 0);
  REQUIRE(outcomes[Recipe::coincident].signs[1] > trials(500));
}

TEMPLATE_TEST_CASE("orient3d: swapping two points flips the sign", "[predicates][law]", Filtered, Rational)
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 8);
    for (int i = 0; i < trials(100); ++i) {
      auto t = source.tuple<4>();
      Sign const s = orient3d<TestType>(t[0], t[1], t[2], t[3]);
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = a + 1; b < 4; ++b) {
          std::swap(t[a], t[b]);
          REQUIRE(orient3d<TestType>(t[0], t[1], t[2], t[3]) == -s);
          std::swap(t[a], t[b]);
        }
    }
  }
}

TEST_CASE("orient3d: the sign is CGAL's", "[predicates][oracle]")
{
  using K = CGAL::Exact_predicates_inexact_constructions_kernel;
  auto const cgal = [](Point3d const& p) { return K::Point_3(p.x, p.y, p.z); };
  for (Recipe const recipe : {Recipe::uniform, Recipe::grid, Recipe::coplanar, Recipe::rounded, Recipe::nextafter}) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 9);
    for (int i = 0; i < trials(500); ++i) {
      auto const [p, q, r, s] = source.tuple<4>();
      REQUIRE(static_cast<int>(orient3d<Filtered>(p, q, r, s)) ==
              static_cast<int>(CGAL::orientation(cgal(p), cgal(q), cgal(r), cgal(s))));
    }
  }
}

TEST_CASE("orient3d: a known input is decided by the layer that is meant for it", "[predicates][layer]")
{
  auto const layer = [](Point3d p, Point3d q, Point3d r, Point3d s, Sign sign) {
    return deciding_layer([&] { REQUIRE(orient3d<TalliedFiltered>(p, q, r, s) == sign); });
  };
  Point3d const p{0.1, 0.2, 0.3}, q{1.7, 0.9, 0.4}, r{0.3, 1.9, 0.8}, s{0.7, 0.1, 2.3};
  CHECK(layer({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, Sign::positive) == Layer::filter);
  CHECK(layer({0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 1}, Sign::negative) == Layer::filter);
  // Equal heights, and every pair of equal points.
  CHECK(layer({0.1, 0.2, 0.7}, {1.7, 0.9, 0.7}, {0.3, 1.9, 0.7}, {0.7, 0.1, 0.7}, Sign::zero) == Layer::filter);
  CHECK(layer(p, p, r, s, Sign::zero) == Layer::filter);
  CHECK(layer(p, q, p, s, Sign::zero) == Layer::filter);
  CHECK(layer(p, q, q, s, Sign::zero) == Layer::filter);
  CHECK(layer(p, q, r, p, Sign::zero) == Layer::filter);
  CHECK(layer(p, q, r, q, Sign::zero) == Layer::filter);
  CHECK(layer(p, q, r, r, Sign::zero) == Layer::filter);
  CHECK(layer({0, 0, 0}, {1, 2, 3}, {3, 5, 7}, {4, 7, 10}, Sign::zero) <= Layer::interval);
  CHECK(layer({1e308, 0, 0}, {-1e308, 0, 0}, {0, 1e308, 0}, {0, 0, 1e308}, Sign::negative) == Layer::exact);
}

TEST_CASE("orient3d: over a vertical edge it is orient2d of the foot", "[predicates][law]")
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 10);
    for (int i = 0; i < trials(200); ++i) {
      auto const [p, q, foot] = source.tuple<3>();
      Point3d const above{foot.x, foot.y, std::nextafter(foot.z, HUGE_VAL)};
      if (!std::isfinite(above.z)) continue;
      REQUIRE(orient3d<Filtered>(p, q, foot, above) ==
              orient2d<Filtered>(horizontal(p), horizontal(q), horizontal(foot)));
    }
  }
}
