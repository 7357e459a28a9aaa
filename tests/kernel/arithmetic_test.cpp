#include "support/catch.hpp"
#include "visibility/kernel/arithmetic.hpp"

#include <cfenv>
#include <limits>

using namespace visibility;

namespace {

/// x y - z: the smallest formula that tells the layers apart.
struct ProductMinus {
  template <class T>
  auto operator()(T const& x, T const& y, T const& z) const
  {
    return x * y - z;
  }
};

}  // namespace

TEST_CASE("build: products are not contracted into fused multiply-adds", "[build]")
{
  double volatile const a = 1 + 0x1p-30, b = 1 + 0x1p-29;
  CHECK(a * a - b == 0);  // the exact value is 2^-60
}

TEST_CASE("build: subnormal numbers are not flushed to zero", "[build]")
{
  double volatile const smallest = std::numeric_limits<double>::denorm_min(),
                        least = std::numeric_limits<double>::min();
  CHECK(smallest > 0);
  CHECK(least / 2 > 0);
  CHECK(least - least * (1 - 0x1p-52) > 0);
}

TEST_CASE("arithmetic: what double cannot tell apart, Filtered and Rational can", "[kernel][law]")
{
  double const a = 1 + 0x1p-30;
  CHECK(Double::sign(ProductMinus{}, a, a, 1 + 0x1p-29) == Sign::zero);
  CHECK(Filtered::sign(ProductMinus{}, a, a, 1 + 0x1p-29) == Sign::positive);
  CHECK(Rational::sign(ProductMinus{}, a, a, 1 + 0x1p-29) == Sign::positive);
}

TEST_CASE("Rational: takes rational arguments", "[kernel]")
{
  RationalNumber const third = RationalNumber(1) / RationalNumber(3);
  CHECK(Rational::sign(ProductMinus{}, third, RationalNumber(3), RationalNumber(1)) == Sign::zero);
}

TEST_CASE("tally: each layer counts what it decided", "[kernel][layer]")
{
  ThreadTally::reset();
  auto const ask = [](double x, double y, double z) { return TalliedFiltered::sign(ProductMinus{}, x, y, z); };
  CHECK(ask(2, 3, 5) == Sign::positive);  // filter
  CHECK(ThreadTally::counts.filter == 1);
  CHECK(ask(0, 3, 0) == Sign::zero);  // structural zero
  CHECK(ThreadTally::counts.filter == 2);
  CHECK(ask(2, 3, 6) == Sign::zero);  // exact in intervals
  CHECK(ThreadTally::counts.interval == 1);
  CHECK(ask(1 + 0x1p-30, 1 + 0x1p-30, 1 + 0x1p-29) == Sign::positive);
  CHECK(ThreadTally::counts.exact == 1);
  CHECK(ThreadTally::counts.total() == 4);
}

TEST_CASE("arithmetic: the interval layer leaves the rounding mode as it was", "[kernel]")
{
  Filtered::sign(ProductMinus{}, 2.0, 3.0, 6.0);
  CHECK(std::fegetround() == FE_TONEAREST);
}
