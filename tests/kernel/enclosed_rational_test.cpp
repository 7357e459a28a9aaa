#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/kernel/enclosed_rational.hpp"
#include "visibility/predicates/orient2d.hpp"

using namespace visibility;
using namespace visibility::test;

TEST_CASE("filtered rational: signs are those of rational numbers", "[kernel][law]")
{
  Random random(5);
  int zeros = 0, thirds = 0;
  for (int i = 0; i < trials(2000); ++i) {
    auto const number = [&] { return RationalNumber(random.between(-30, 30), random.between(1, 3)); };
    RationalNumber const x = number(), y = number(), dx = number(), dy = number();
    // On the line, or beside it by what no double shows.
    RationalNumber const off =
      random.chance(0.5) ? RationalNumber(0) : RationalNumber(random.between(-1, 1)) * RationalNumber(0x1p-80);
    Point2q const p{x, y}, q{x + dx, y + dy}, r{x + RationalNumber(3) * dx, y + RationalNumber(3) * dy + off};
    Point2<EnclosedRational> const ep{p.x, p.y}, eq{q.x, q.y}, er{r.x, r.y};
    Sign const expected = orient2d<Rational>(p, q, r);
    CHECK(orient2d<FilteredRational>(ep, eq, er) == expected);
    zeros += is_zero(expected);
    thirds += ep.x.low() < ep.x.high();
  }
  CHECK(zeros > trials(500));
  CHECK(thirds > trials(300));
}

TEST_CASE("filtered rational: doubles are what they are, however large", "[kernel][layer]")
{
  EnclosedRational const x(1e300);
  CHECK(x.low() == 1e300);
  CHECK(x.high() == 1e300);
  CHECK(x.exact() == RationalNumber(1e300));
  Point2<EnclosedRational> const p{1e300, 0.0}, q{-1e300, 1.0}, r{1e300, 1e-300};
  CHECK(orient2d<FilteredRational>(p, q, r) == Sign::negative);
}
