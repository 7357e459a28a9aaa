#include "support/catch.hpp"
#include "visibility/kernel/sign.hpp"

#include <limits>

using namespace visibility;

TEST_CASE("Sign: negation and product are those of numbers", "[kernel][law]")
{
  for (int a = -1; a <= 1; ++a) {
    CHECK(-static_cast<Sign>(a) == static_cast<Sign>(-a));
    for (int b = -1; b <= 1; ++b) CHECK(static_cast<Sign>(a) * static_cast<Sign>(b) == static_cast<Sign>(a * b));
  }
}

TEST_CASE("sign_of: both zeros are zero, subnormals and infinities have a sign, NaN has none", "[kernel]")
{
  using limits = std::numeric_limits<double>;
  CHECK(sign_of(0.0) == Sign::zero);
  CHECK(sign_of(-0.0) == Sign::zero);
  CHECK(sign_of(limits::denorm_min()) == Sign::positive);
  CHECK(sign_of(-limits::infinity()) == Sign::negative);
  CHECK(sign_of(limits::quiet_NaN()) == Sign::zero);
  CHECK((is_positive(Sign::positive) && is_negative(Sign::negative) && is_zero(Sign::zero)));
}
