#include "support/catch.hpp"
#include "support/recipes.hpp"
#include "support/trials.hpp"
#include "visibility/kernel/number_types.hpp"
#include "visibility/kernel/sign.hpp"

#include <limits>

using namespace visibility;
using namespace visibility::test;

namespace {

/// a b - c d + (a - b) (c + d) e: sums and products of numbers whose exponents have nothing in common.
template <class T>
int sign_of_mixture(double a, double b, double c, double d, double e)
{
  T const A(a), B(b), C(c), D(d), E(e);
  return static_cast<int>(CGAL::sign(A * B - C * D + (A - B) * (C + D) * E));
}

double any_double(Random& random)
{
  using limits = std::numeric_limits<double>;
  static constexpr double special[] = {0.0,           -0.0,           limits::denorm_min(),   -limits::denorm_min(),
                                       limits::min(), -limits::min(), limits::max(),          -limits::max(),
                                       1.0,           -1.0,           0x1.fffffffffffffp-1023};
  if (random.chance(0.25)) return special[random.below(11)];
  for (;;) {
    double const x = std::bit_cast<double>(random.bits());
    if (std::isfinite(x)) return random.chance(0.2) ? x * 0x1p-1000 : x;
  }
}

}  // namespace

TEST_CASE("ExactNumber: its signs are those of rationals for all finite doubles", "[kernel][oracle]")
{
  Random random(41);
  for (int i = 0; i < trials(20000); ++i) {
    double x[5];
    for (auto& v : x) v = any_double(random);
    if (random.chance(0.3)) x[2] = x[0], x[3] = x[1];  // a b - c d cancels
    CAPTURE(x[0], x[1], x[2], x[3], x[4]);
    REQUIRE(sign_of_mixture<ExactNumber>(x[0], x[1], x[2], x[3], x[4]) ==
            sign_of_mixture<RationalNumber>(x[0], x[1], x[2], x[3], x[4]));
  }
}

TEST_CASE("ExactNumber and RationalNumber: a double converts exactly, down to the smallest subnormal",
          "[kernel][oracle]")
{
  Random random(42);
  for (int i = 0; i < trials(2000); ++i) {
    double const x = any_double(random), y = any_double(random);
    CAPTURE(x, y);
    REQUIRE(static_cast<int>(CGAL::sign(ExactNumber(x) - ExactNumber(y))) == (x > y) - (x < y));
    REQUIRE(static_cast<int>(CGAL::sign(RationalNumber(x) - RationalNumber(y))) == (x > y) - (x < y));
    // Mantissa and exponent apart: a conversion that drops bits of a subnormal would show here.
    int exponent = 0;
    double const mantissa = std::frexp(x, &exponent);
    RationalNumber power = 1;
    for (int e = 0; e < std::abs(exponent); ++e) power *= 2;
    REQUIRE(RationalNumber(x) == (exponent < 0 ? RationalNumber(mantissa) / power : RationalNumber(mantissa) * power));
    REQUIRE(CGAL::to_double(ExactNumber(x)) == x);
  }
}
