#include "support/catch.hpp"
#include "support/random.hpp"

#include "decimal.hpp"
#include "numbers.hpp"

#include "visibility/kernel/number_types.hpp"

#include <bit>
#include <cmath>

using namespace visibility;
using namespace visibility::readers;

TEST_CASE("numbers: shortest decimals read back as the same bits", "[readers][law]")
{
  test::Random random(1);
  for (int i = 0; i < 100000; ++i) {
    double const d = std::bit_cast<double>(random.bits());
    if (!std::isfinite(d)) continue;
    CAPTURE(d);
    auto const back = parse_double(shortest(d));
    REQUIRE(back);
    REQUIRE(std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(d));
  }
}

TEST_CASE("numbers: whole numbers are written in full", "[readers]")
{
  CHECK(shortest(100000) == "100000");
  CHECK(shortest(-9007199254740992.0) == "-9007199254740992");
  CHECK(shortest(0.1) == "0.1");
  CHECK(shortest(-0.0) == "-0.0");
}

TEST_CASE("numbers: overflow is infinite, underflow zero, whatever the spelling", "[readers]")
{
  auto const nines = std::string(400, '9');
  for (std::string const text : {"1e309", "1e999", "1e99999999999999999999", "0.1e310", nines.c_str(), "+1e400"})
    CHECK(parse_double(text) == HUGE_VAL);
  CHECK(parse_double("-1e999") == -HUGE_VAL);
  for (std::string const text :
       {"1e-400", "1e-99999999999999999999", "2e-324", "-1e-999", "0.00000000000000000001e-320", "0e999"})
    CHECK(parse_double(text) == 0.0);
  CHECK(std::signbit(*parse_double("-1e-999")));
  CHECK(parse_double("." + std::string(400, '0') + "1") == 0.0);
  CHECK(std::isnan(*parse_double("nan")));
  for (std::string const text : {"", "-", "+", "+-1", "e5", "1x", "0x10", " 1", "1 ", "1e", "--1"})
    CHECK_FALSE(parse_double(text));
}

TEST_CASE("decimal transform: equals the rational value rounded once", "[readers][law]")
{
  test::Random random(2);
  auto const power = [](int n) {
    RationalNumber p(1);
    for (int i = 0; i < std::abs(n); ++i) p = p * RationalNumber(10);
    return n < 0 ? RationalNumber(1) / p : p;
  };
  // Nearest: no neighbouring double is closer to the exact value.
  auto const is_nearest = [](double d, RationalNumber const& exact) {
    auto const off = [&](double x) { return CGAL::abs(RationalNumber(x) - exact); };
    return off(d) <= off(std::nextafter(d, HUGE_VAL)) && off(d) <= off(std::nextafter(d, -HUGE_VAL));
  };
  int slow = 0;
  for (int i = 0; i < 20000; ++i) {
    int const scale_exponent = -random.between(0, 25), translate_exponent = -random.between(0, 12);
    long const scale = random.between(1, 3), translate = static_cast<long>(random.bits() >> random.between(20, 62));
    long const index = static_cast<long>(random.bits() >> random.between(10, 60)) - 1000;
    auto const decimal = [](long digits, int e) {
      return *Decimal::parse(std::to_string(digits) + "e" + std::to_string(e));
    };
    DecimalTransform const transform(decimal(scale, scale_exponent), decimal(translate, translate_exponent));
    RationalNumber const exact =
      RationalNumber(CGAL::Gmpz(index)) * RationalNumber(CGAL::Gmpz(scale)) * power(scale_exponent) +
      RationalNumber(CGAL::Gmpz(translate)) * power(translate_exponent);
    CAPTURE(scale, scale_exponent, translate, translate_exponent, index);
    REQUIRE(is_nearest(transform(std::int64_t{index}), exact));
    REQUIRE(transform(decimal(index, 0)) == transform(std::int64_t{index}));
    slow += scale_exponent < -22;
  }
  REQUIRE(slow > 100);  // the branch in big integers was taken
}

TEST_CASE("decimal: parts of a number", "[readers]")
{
  auto const d = Decimal::parse("-012.50e-3");
  REQUIRE(d);
  CHECK(d->digits == -1250);
  CHECK(d->exponent == -5);
  CHECK(Decimal::parse("0.000")->digits == 0);
  for (std::string const text : {"", "-", "1e9999", "1.2.3", "nan", "1e", "0x1"}) CHECK_FALSE(Decimal::parse(text));
}
