#include "support/catch.hpp"
#include "support/recipes.hpp"
#include "support/trials.hpp"
#include "visibility/kernel/arithmetic.hpp"

#include <limits>

using namespace visibility;
using namespace visibility::test;

namespace {

/// Random formulas of degree <= 6 with every shape that the composition rules know: input times input, sums of inputs,
/// sums of products, products of sums, a product with an input, a bare input.
template <int Shape>
struct Shaped {
  template <class T>
  auto operator()(T const& a, T const& b, T const& c, T const& d) const
  {
    if constexpr (Shape == 0)
      return a - b;
    else if constexpr (Shape == 1)
      return a * b - c * d;
    else if constexpr (Shape == 2)
      return (a - b) * (c + d) - a * c;
    else if constexpr (Shape == 3)
      return ((a - b) - (c - d)) * (a + b) + d;
    else if constexpr (Shape == 4)
      return (a * b - c * d) * (a * c - b * d) * (a * d - b * c);
    else if constexpr (Shape == 5)
      return a * (b * (c * (d - a))) - (a + b) * (c * d) * (a - d);
    else if constexpr (Shape == 6)
      return (a - b) + (c - d);
    else if constexpr (Shape == 7)
      return (a - b) - c + (a * a) * d - d * (c * c);
    else
      return a;
  }
};

double varied(Random& random)
{
  if (random.chance(0.1)) return 0;
  double const m = random.chance(0.5) ? double(random.between(-5, 5)) : random.uniform(-1, 1);
  switch (random.below(6)) {
  case 0: return std::ldexp(m, random.between(-1074, 1020));
  case 1: return std::ldexp(m, random.between(-360, -150));  // products underflow
  case 2: return std::ldexp(m, random.between(150, 360));    // products overflow
  case 3: return std::ldexp(m, -1070);
  default: return m;
  }
}

template <int Shape>
void check_shape()
{
  Random random(50 + Shape);
  int certified = 0;
  for (int i = 0; i < trials(10000); ++i) {
    double a = varied(random), b = varied(random), c = varied(random), d = varied(random);
    if (random.chance(0.3)) c = a, d = b;
    if (random.chance(0.3)) b = std::nextafter(a, d);
    Shaped<Shape> const f;
    Sign const truth = Rational::sign(f, a, b, c, d);
    CAPTURE(Shape, a, b, c, d);
    auto const fits = [&](MaybeSign s) { return !s || *s == truth; };
    REQUIRE(fits(layers::filter(f, a, b, c, d)));
    REQUIRE(fits(layers::interval(f, a, b, c, d)));
    REQUIRE(layers::exact(f, a, b, c, d) == truth);
    REQUIRE(Filtered::sign(f, a, b, c, d) == truth);
    certified += layers::filter(f, a, b, c, d).has_value();
  }
  REQUIRE(certified > 0);
}

}  // namespace

TEST_CASE("layers: whatever shape a formula has, no layer ever says a wrong sign", "[kernel][agreement]")
{
  check_shape<0>();
  check_shape<1>();
  check_shape<2>();
  check_shape<3>();
  check_shape<4>();
  check_shape<5>();
  check_shape<6>();
  check_shape<7>();
  check_shape<8>();
}

TEST_CASE("filter: an overflow certifies nothing", "[kernel][layer]")
{
  double const big = std::numeric_limits<double>::max();
  CHECK_FALSE(layers::filter(Shaped<1>{}, big, big, 1.0, 1.0));
  CHECK_FALSE(layers::filter(Shaped<1>{}, big, big, big, big / 2));
  CHECK_FALSE(layers::filter(Shaped<0>{}, big, -big, 0.0, 0.0));
  CHECK_FALSE(
    bounded::certified_sign((bounded::Input{big} - bounded::Input{-big}) * bounded::Input{0}));  // infinity times zero
  CHECK(Filtered::sign(Shaped<2>{}, big, -big, 0.0, 0.0) == Sign::zero);
}

TEST_CASE("filter: an underflow certifies nothing", "[kernel][layer]")
{
  CHECK_FALSE(layers::filter(Shaped<1>{}, 0x1p-600, 0x1p-600, 0x1p-600, 0x1p-601));
  CHECK_FALSE(layers::filter(Shaped<1>{}, 0x1p-520, 0x1p-520, 0x1p-520, 0x1p-521));  // below the guard
  CHECK(layers::filter(Shaped<1>{}, 0x1p-400, 0x1p-400, 0x1p-400, 0x1p-401) == Sign::positive);
}

TEST_CASE("interval: outside its domain it abstains, inside it cannot overflow", "[kernel][layer]")
{
  double const edge = layers::interval_domain;
  CHECK_FALSE(layers::interval(Shaped<1>{}, std::nextafter(edge, HUGE_VAL), 1.0, 1.0, 1.0));
  CHECK_FALSE(layers::interval(Shaped<1>{}, std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0, 1.0));
  CHECK_FALSE(layers::interval(Shaped<1>{}, HUGE_VAL, 1.0, 1.0, 1.0));
  CHECK(layers::interval(Shaped<4>{}, edge, edge / 2, edge / 4, edge) ==
        Rational::sign(Shaped<4>{}, edge, edge / 2, edge / 4, edge));
  CHECK(layers::interval(Shaped<1>{}, 3.0, 5.0, 15.0, 1.0) == Sign::zero);
}
