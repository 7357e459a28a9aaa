#include "support/catch.hpp"
#include "support/recipes.hpp"
#include "support/trials.hpp"
#include "visibility/kernel/arithmetic.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

struct Mixed {
  template <class T>
  auto operator()(T const& a, T const& b, T const& c, T const& d) const
  {
    return (a + b) * (c - d) - (a - b) * (c + d) + a * (b - c) + d * c;
  }
};

}  // namespace

TEST_CASE("StructuralZero: what it calls zero is zero", "[kernel][law]")
{
  Random random(40);
  double const values[] = {0.0, -0.0, 1, -1, 0.1, -0.1, 1e308, -1e308, 0x1p-1074, -0x1p-1074};
  int zeros = 0;
  for (int i = 0; i < trials(20000); ++i) {
    auto const pick = [&] { return values[random.below(10)]; };
    double const a = pick(), b = pick(), c = pick(), d = pick();
    StructuralZero const pattern =
      Mixed{}(StructuralInput{a}, StructuralInput{b}, StructuralInput{c}, StructuralInput{d});
    if (!pattern.zero) continue;
    ++zeros;
    CAPTURE(a, b, c, d);
    REQUIRE(Rational::sign(Mixed{}, a, b, c, d) == Sign::zero);
  }
  REQUIRE(zeros > 0);
}

TEST_CASE("StructuralZero: sums of opposite and differences of equal inputs are zero, also where doubles overflow",
          "[kernel]")
{
  using In = StructuralInput;
  CHECK((In{1e308} - In{1e308}).zero);
  CHECK((In{1e308} + In{-1e308}).zero);
  CHECK_FALSE((In{1e308} + In{1e308}).zero);
  CHECK_FALSE((In{0.1} - In{0.2}).zero);
  CHECK((In{0.0} - In{-0.0}).zero);
  CHECK((In{0.0} * In{5}).zero);
  CHECK_FALSE((In{0x1p-1074} * In{0x1p-1074}).zero);  // underflows in double
}
