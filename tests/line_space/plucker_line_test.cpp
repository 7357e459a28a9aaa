#include "support/catch.hpp"
#include "support/recipes.hpp"
#include "support/trials.hpp"
#include "visibility/line_space/primitive.hpp"
#include "visibility/predicates/line_side.hpp"
#include "visibility/predicates/orient2d.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

template <class NT>
Point3<NT> as(Point3d const& p)
{
  return {NT(p.x), NT(p.y), NT(p.z)};
}

template <class NT>
PluckerLine<NT> through(Point3d const& p, Point3d const& q)
{
  return line_through(as<NT>(p), as<NT>(q));
}

}  // namespace

TEMPLATE_TEST_CASE("plucker_product: its sign is that of orient3d of the four points", "[line_space][law]", ExactNumber,
                   RationalNumber)
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 61);
    for (int i = 0; i < trials(100); ++i) {
      auto const [p, q, r, s] = source.tuple<4>();
      auto const k = through<TestType>(p, q), l = through<TestType>(r, s);
      Sign const side = number_sign(plucker_product(k, l));
      REQUIRE(side == orient3d<Filtered>(p, q, r, s));
      REQUIRE(side == number_sign(plucker_product(l, k)));
      REQUIRE(-side == number_sign(plucker_product(reversed(k), l)));
      REQUIRE(is_zero(number_sign(plucker_form(k))));
    }
  }
}

TEST_CASE("vertical_line: its side is that of its foot seen from above", "[line_space][law]")
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 62);
    for (int i = 0; i < trials(100); ++i) {
      auto const [p, q, r] = source.tuple<3>();
      auto const up = vertical_line(Point2<ExactNumber>{ExactNumber(r.x), ExactNumber(r.y)});
      REQUIRE(number_sign(plucker_product(through<ExactNumber>(p, q), up)) ==
              orient2d<Filtered>(horizontal(p), horizontal(q), horizontal(r)));
    }
  }
}

TEST_CASE("two_points: they are on the line, in its direction", "[line_space][law]")
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 63);
    for (int i = 0; i < trials(20); ++i) {
      auto const [p, q] = source.tuple<2>();
      auto const line = through<RationalNumber>(p, q);
      if (p == q) {
        REQUIRE_THROWS_AS(two_points(line), std::invalid_argument);
        continue;
      }
      auto const [a, b] = two_points(line);
      REQUIRE(line_through(a, b) == line);
    }
  }
  PluckerLine<RationalNumber> no_line;
  no_line.direction[0] = no_line.moment[0] = 1;
  CHECK_THROWS_AS(two_points(no_line), std::invalid_argument);
}

TEMPLATE_TEST_CASE("make_primitive: a positive multiple with coprime components", "[line_space][law]", ExactNumber,
                   CGAL::Gmpz, RationalNumber)
{
  Random random(64);
  for (int i = 0; i < trials(500); ++i) {
    PluckerLine<TestType> l;
    for (std::size_t j = 0; j < 6; ++j) l[j] = TestType(random.between(-20, 20));
    auto scaled = l;
    TestType factor(random.between(1, 1000));
    for (int j = 0; j < 4; ++j) factor = factor * TestType(random.between(1, 1000000));
    for (std::size_t j = 0; j < 6; ++j) scaled[j] = l[j] * factor;
    make_primitive(scaled);
    make_primitive(l);
    REQUIRE(scaled == l);
    for (std::size_t j = 0; j < 6; ++j) REQUIRE(magnitude(l[j]) <= TestType(20));
  }
  PluckerLine<TestType> zero;
  make_primitive(zero);
  CHECK(is_zero(zero));
}
