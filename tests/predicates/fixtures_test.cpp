#include "support/fixtures.hpp"
#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

using namespace visibility;
using namespace visibility::test;

TEMPLATE_TEST_CASE("orient2d: the published exact signs are reproduced", "[predicates][oracle]", Filtered, Rational)
{
  for_each_fixture<6>("orient2d.txt", [](auto const& x, Sign s) {
    REQUIRE(orient2d<TestType>(Point2d{x[0], x[1]}, Point2d{x[2], x[3]}, Point2d{x[4], x[5]}) == s);
  });
}

TEMPLATE_TEST_CASE("orient3d: the published exact signs are reproduced, turned round", "[predicates][oracle]", Filtered,
                   Rational)
{
  // Shewchuk's orient3d is positive where ours is negative.
  for_each_fixture<12>("orient3d.txt", [](auto const& x, Sign s) {
    auto const point = [&](std::size_t i) { return Point3d{x[3 * i], x[3 * i + 1], x[3 * i + 2]}; };
    REQUIRE(orient3d<TestType>(point(0), point(1), point(2), point(3)) == -s);
  });
}
