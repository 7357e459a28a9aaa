#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"
#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/in_ball.hpp"
#include "visibility/predicates/line_ball.hpp"
#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <cmath>

/// Recomputes in rationals what proofs/filters.md claims of the constants in the code, and tries Theorem 1 on numbers.

using namespace visibility;
using namespace visibility::test;
using NT = RationalNumber;

namespace {

NT power(NT const& base, int n)
{
  NT result = 1;
  for (int i = 0; i < n; ++i) result *= base;
  return result;
}

NT const u(bounded::u);
NT gamma(int k) { return power(1 + u, k) - 1; }

/// Calls check(std::integral_constant<int, K>) for K = 0, ..., Last.
template <int Last, class Check>
void for_each_k(Check const& check)
{
  [&]<int... K>(std::integer_sequence<int, K...>) { (check(std::integral_constant<int, K>{}), ...); }
  (std::make_integer_sequence<int, Last + 1>{});
}

/// How many roundings the type of a formula counts.
template <class Formula, std::size_t N>
constexpr int roundings = []<std::size_t... I>(std::index_sequence<I...>)
{
  return decltype(Formula{}((static_cast<void>(I), bounded::Input{0})...))::roundings;
}
(std::make_index_sequence<N>{});

/// The degree of a formula, as a number type.
struct Degree {
  int d;
};
Degree operator+(Degree a, Degree b) { return {std::max(a.d, b.d)}; }
Degree operator-(Degree a, Degree b) { return {std::max(a.d, b.d)}; }
Degree operator*(Degree a, Degree b) { return {a.d + b.d}; }

template <class Formula, std::size_t N>
int degree()
{
  return []<std::size_t... I>(std::index_sequence<I...>) { return Formula{}((static_cast<void>(I), Degree{1})...).d; }
  (std::make_index_sequence<N>{});
}

NT absolute(NT const& x) { return x < 0 ? NT(-x) : x; }

}  // namespace

TEST_CASE("bounds: relative_bound covers gamma and the rounding of its product with the magnitude", "[proofs]")
{
  auto const check = [](auto k) {
    constexpr int K = decltype(k)::value;
    CAPTURE(K);
    NT const c(bounded::relative_bound<K>);
    REQUIRE(c * (1 - u) >= gamma(K));
    // room for an underflow of that product: half a subnormal, m >= 2^-1022
    REQUIRE((c - gamma(K)) * NT(0x1p-1022) >= NT(0x1p-1074) / 2);
    REQUIRE(c <= (K + 3) * u);  // and not much more
  };
  for_each_k<64>(check);
  check(std::integral_constant<int, 1000>{});
}

TEST_CASE("bounds: the guard swallows the underflow of a product", "[proofs]")
{
  NT const g(bounded::underflow_guard), half_least = NT(0x1p-1074) / 2, least_normal(0x1p-1022);
  auto const check = [&](auto k) {
    constexpr int K = decltype(k)::value;
    CAPTURE(K);
    REQUIRE(gamma(K) * least_normal + (1 + gamma(K)) * half_least <= gamma(K) * g);
  };
  check(std::integral_constant<int, 1>{});
  check(std::integral_constant<int, 12>{});
  check(std::integral_constant<int, 1000>{});
  REQUIRE(bounded::underflow_guard + 0x1p-1022 == bounded::underflow_guard);  // fl(P + g) >= g, used as such
}

TEST_CASE("bounds: the types count the roundings and degrees that the proof states", "[proofs]")
{
  STATIC_REQUIRE(roundings<detail::Orient2dFormula, 6> == 4);
  STATIC_REQUIRE(roundings<detail::Orient3dFormula, 12> == 8);
  STATIC_REQUIRE(roundings<detail::InBallFormula, 7> == 6);
  STATIC_REQUIRE(roundings<detail::AlongFormula, 9> == 5);
  STATIC_REQUIRE(roundings<detail::LineBallFormula, 10> == 12);
  CHECK(degree<detail::Orient2dFormula, 6>() == 2);
  CHECK(degree<detail::Orient3dFormula, 12>() == 3);
  CHECK(degree<detail::InBallFormula, 7>() == 2);
  CHECK(degree<detail::AlongFormula, 9>() == 2);
  CHECK(degree<detail::LineBallFormula, 10>() == 4);
}

TEST_CASE("bounds: nothing of the interval layer's degree can overflow in its domain", "[proofs]")
{
  NT const largest(std::numeric_limits<double>::max());
  NT const difference = 2 * NT(layers::interval_domain) * (1 + u) * (1 + u);
  CHECK(power(difference, layers::max_degree) * NT(0x1p40) * 2 < largest);
}

namespace {

double anywhere(Random& random)
{
  double const m = random.chance(0.3) ? double(random.between(-3, 3)) : random.uniform(-1, 1);
  return random.chance(0.5)
           ? m
           : std::ldexp(m, random.chance(0.5) ? random.between(-1074, 330) : random.between(-560, -300));
}

/// |v - t| <= gamma_K m and |v| <= m.
template <bounded::Number X>
void check_theorem(X const& x, NT const& t)
{
  double const m = x.magnitude();
  if (!std::isfinite(m)) return;
  CAPTURE(X::roundings, x.v, m);
  REQUIRE(absolute(NT(x.v) - t) <= gamma(X::roundings) * NT(m));
  REQUIRE(std::fabs(x.v) <= m);
}

}  // namespace

TEST_CASE("bounds: Theorem 1 holds for compositions of every kind, underflow included", "[proofs]")
{
  Random random(80);
  for (int i = 0; i < trials(5000); ++i) {
    double const x[6] = {anywhere(random), anywhere(random), anywhere(random),
                         anywhere(random), anywhere(random), anywhere(random)};
    CAPTURE(i, x[0], x[1], x[2], x[3], x[4], x[5]);
    auto const steps = [&]<class T>(std::type_identity<T>) {
      T const a{x[0]}, b{x[1]}, c{x[2]}, d{x[3]}, e{x[4]}, f{x[5]};
      auto const difference = a - b, sum = c + d;
      auto const input_product = e * f, product = difference * sum;
      auto const of_products = product - input_product, mixed = difference + product, of_leaves = difference - sum;
      auto const minor = (a * d - b * c) * (e - f), square = minor * minor,
                 deep = (square - of_products) * mixed + of_leaves * e;
      return std::tuple(difference, sum, input_product, product, of_products, mixed, of_leaves, minor, square, deep);
    };
    auto const approximate = steps(std::type_identity<bounded::Input>{});
    auto const truth = steps(std::type_identity<NT>{});
    [&]<std::size_t... I>(std::index_sequence<I...>)
    {
      (check_theorem(std::get<I>(approximate), std::get<I>(truth)), ...);
    }
    (std::make_index_sequence<10>{});
  }
}
