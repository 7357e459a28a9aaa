// The integrals and laws of proofs/strong_occlusion_model.md, against quadrature written here.

#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/kernel/number_types.hpp"
#include "visibility/methods/strong_occlusion/model.hpp"

#include <cmath>
#include <limits>
#include <numbers>

using namespace visibility::test;
namespace model = visibility::strong_occlusion::model;
namespace plane = model::plane;
namespace space = model::space;
using std::numbers::pi;

namespace {

/// Simpson's rule.
template <class F>
double integral(F const& f, double from, double to, int pieces = 40'000)
{
  double const h = (to - from) / pieces;
  double sum = f(from) + f(to);
  for (int i = 1; i < pieces; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(from + i * h);
  return sum * h / 3;
}

double mean_ratio(double R, double cell) { return 2 * R / (R + cell); }

struct Sizes {
  double R, cell, r0;
};

/// The paper's text, with its ln; nothing of it is taken from the model.
double printed_conservatively_visible(Sizes const& s)
{
  double const b = (3 * s.R + s.cell) / 4, l = std::log((mean_ratio(s.R, s.cell) + 1) / 2);
  return pi * std::pow(s.cell + s.r0, 2) / 4 + pi / 2 * (1 + s.r0 * b * l) / (b * b * l) * std::exp(-s.r0 * b * l);
}

double printed_visible(Sizes const& s)
{
  double const b = (3 * s.R + s.cell) / 4, l = std::log(mean_ratio(s.R, s.cell) + 1), x = s.r0 * b;
  return pi * std::pow(s.cell + s.r0, 2) / 4 +
         pi / (2 * b * b * l * l * l) * std::exp(-x * l) * (2 + (2 * x + 1) * l + (x * x + x) * l * l);
}

}  // namespace

TEST_CASE("strong occlusion model: closed forms equal the integrals of the plane", "[methods][model]")
{
  auto const s =
    GENERATE(Sizes{0.5, 0, 0}, Sizes{0.5, 0.1, 0}, Sizes{0.5, 0.2, 3}, Sizes{0.9, 0.6, 1}, Sizes{0.1, 0.05, 20});
  CAPTURE(s.R, s.cell, s.r0);
  double const m = mean_ratio(s.R, s.cell), rate = (3 * s.R + s.cell) / 4;
  double const near = pi * std::pow(s.cell + s.r0, 2) / 4;
  auto const far = [&](double growth, double base) {  // until e^-50
    double const to = s.r0 + 60 / (rate * std::log(base));
    return integral([=](double r) { return pi / 2 * r * (1 + growth * rate * r) * std::pow(base, -rate * r); }, s.r0,
                    to);
  };
  REQUIRE(plane::visible_estimate(s.R, s.cell, s.r0) == Approx(near + far(1, m + 1)).epsilon(1e-9));
  REQUIRE(printed_visible(s) == Approx(near + far(1, m + 1)).epsilon(1e-9));  // the scan is right here

  double const truth = near + far(0, (m + 1) / 2);
  REQUIRE(plane::conservatively_visible_estimate(s.R, s.cell, s.r0) == Approx(truth).epsilon(1e-9));
  REQUIRE(std::abs(printed_conservatively_visible(s) - truth) > 0.2 * truth);  // and wrong here
  double const log_of_base = std::log((m + 1) / 2);
  REQUIRE((printed_conservatively_visible(s) - near) / log_of_base == Approx(truth - near).epsilon(1e-9));
}

TEST_CASE("strong occlusion model: counts in Poisson scenes equal their integrals", "[methods][model]")
{
  auto const s = GENERATE(Sizes{0.5, 0, 0}, Sizes{0.5, 0.1, 0}, Sizes{0.9, 0.6, 0}, Sizes{0.1, 0.05, 0});
  double const density = GENERATE(0.25, 0.1);
  CAPTURE(s.R, s.cell, density);
  auto const in_plane = [&](auto const& probability) {
    auto const ring = [&](double r) { return (8 * s.cell + 2 * pi * r) * probability(r); };
    return density * (4 * s.cell * s.cell + integral(ring, 0, 60 / (density * (s.R - s.cell))));
  };
  REQUIRE(plane::conservatively_visible_poisson(s.R, s.cell, density) ==
          Approx(in_plane([&](double r) { return std::exp(-density * (s.R - s.cell) * r); })).epsilon(1e-8));
  REQUIRE(plane::visible_poisson(s.R, s.cell, density) == Approx(in_plane([&](double r) {
                                                            double const K =
                                                              plane::potential_occluders(s.R, s.cell, r, density);
                                                            return plane::uncovered_poisson(K, mean_ratio(s.R, s.cell));
                                                          }))
                                                            .epsilon(1e-8));
  double const rate = density * pi / 3 * std::pow(s.R - s.cell, 2);
  auto const shell = [&](double r) {
    return (24 * s.cell * s.cell + 12 * pi * s.cell * r + 4 * pi * r * r) * std::exp(-rate * r);
  };
  REQUIRE(space::conservatively_visible_poisson(s.R, s.cell, density) ==
          Approx(density * (8 * std::pow(s.cell, 3) + integral(shell, 0, 60 / rate))).epsilon(1e-8));
}

TEST_CASE("strong occlusion model: closed forms equal the integrals of space", "[methods][model]")
{
  auto const s = GENERATE(Sizes{0.5, 0, 0}, Sizes{0.5, 0.2, 3}, Sizes{0.9, 0.6, 1}, Sizes{0.3, 0.4, 0});
  CAPTURE(s.R, s.cell, s.r0);
  double const m = mean_ratio(s.R, s.cell), near = pi * std::pow(s.cell + s.r0, 3) / 6;
  double const rate = space::potential_occluders(s.R, s.cell, 1);
  if (s.cell < s.R) {
    double const base = 4 * m / std::pow(1 + m, 2), to = s.r0 - 70 / (rate * std::log(base));
    double const far = integral([=](double r) { return pi / 2 * r * r * std::pow(base, rate * r); }, s.r0, to);
    REQUIRE(space::conservatively_visible_estimate(s.R, s.cell, s.r0) == Approx(near + far).epsilon(1e-9));
  }
  auto const bound = [=](double r) {  // before it is capped by P2-hat
    double const K = rate * r, point = std::pow(m / (1 + m), 2), inside = m < 1 ? std::pow((1 - m) / (1 + m), 2) : 0;
    return std::exp(-K * (1 - inside)) +
           (4 * m / std::pow(1 + m, 2) * K + 4.0 / 3 * m * m / std::pow(1 + m, 4) * K * K) * std::exp(-K * point);
  };
  double const far = integral([=](double r) { return pi / 2 * r * r * bound(r); }, s.r0, s.r0 + 900 / rate);
  REQUIRE(space::visible_estimate(s.R, s.cell, s.r0) == Approx(near + far).epsilon(1e-8));
  for (double const r : {1.0, 10.0, 100.0})
    REQUIRE(space::uncovered_at_most_poisson(rate * r, m) <= bound(r) * (1 + 1e-12));
}

TEST_CASE("strong occlusion model: K is the area of the trapezoid and the volume of the cone", "[methods][model]")
{
  for (double const R : {0.3, 0.9})
    for (double const cell : {0.0, 0.2, 1.5}) {
      double const d = 7;
      auto const reach = [=](double x) { return R + cell + (R - cell) * x / d; };
      REQUIRE(plane::potential_occluders(R, cell, d) ==
              Approx(integral([&](double x) { return 2 * reach(x); }, 0, d) / 4));
      REQUIRE(space::potential_occluders(R, cell, d) ==
              Approx(integral([&](double x) { return pi * reach(x) * reach(x); }, 0, d) / 8));
      REQUIRE(space::potential_occluders(R, cell, d, 2) == Approx(16 * space::potential_occluders(R, cell, d)));
      // Similar scenes: lengths times 3.
      REQUIRE(plane::potential_occluders(3 * R, 3 * cell, 3 * d, 0.25 / 9) ==
              Approx(plane::potential_occluders(R, cell, d)));
      REQUIRE(space::potential_occluders(3 * R, 3 * cell, 3 * d, 0.125 / 27) ==
              Approx(space::potential_occluders(R, cell, d)));
    }
}

TEST_CASE("strong occlusion model: no radius gives less than the best one", "[methods][model]")
{
  int positive = 0;
  for (double const R : {0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0})
    for (double const share : {0.0, 0.1, 0.17, 0.3, 0.6, 1.0, 2.0}) {
      double const cell = share * R, r0 = plane::best_radius(R, cell), best = plane::visible_estimate(R, cell, r0);
      CAPTURE(R, share, r0);
      positive += r0 > 0;
      double last = plane::conservatively_visible_estimate(R, cell, 0);
      for (int i = 1; i <= 400; ++i) {
        double const r = i * 0.02 / R;
        REQUIRE(plane::visible_estimate(R, cell, r) >= best * (1 - 1e-12));
        if (cell >= R) continue;
        double const next = plane::conservatively_visible_estimate(R, cell, r);
        REQUIRE(next >= last * (1 - 1e-12));  // least at 0, whatever the sizes
        last = next;
      }
      // A radius pays only where the printed P1-hat, continued to real K, exceeds 1.
      if (r0 > 0) REQUIRE(mean_ratio(R, cell) < std::numbers::e - 1);
    }
  REQUIRE(positive > 5);
}

TEST_CASE("strong occlusion model: the alternating sum keeps its digits", "[methods][model]")
{
  // Against rationals. For K = 100, m = 1/64 terms reach 10^6, and what is left is 1; for K = 20, m = 1/16 the chance
  // of being covered is 10^-13, the difference of terms up to 28.
  using visibility::RationalNumber;
  int const K = GENERATE(1, 5, 20, 60, 100, 200, 400);
  double const m = GENERATE(0.015625, 0.03125, 0.0625, 0.125, 0.25, 0.625);
  CAPTURE(K, m);
  RationalNumber sum = 0, binomial = 1;
  double largest = 0;
  for (int j = 1; j <= K + 1 && (j - 1) * m < 1; ++j) {
    binomial *= RationalNumber(K + 2 - j, j);
    RationalNumber term = binomial;
    for (int i = 0; i < K; ++i) term *= (1 - RationalNumber(j - 1) * RationalNumber(m)) / (1 + RationalNumber(m));
    sum += j % 2 == 1 ? term : RationalNumber(-term);
    largest = std::max(largest, CGAL::to_double(term));
  }
  CAPTURE(largest, CGAL::to_double(sum));
  REQUIRE(plane::uncovered(K, m) == Approx(CGAL::to_double(sum)).epsilon(1e-14).margin(0));
  if (sum < 1 && largest < 1e12)
    REQUIRE(1 - plane::uncovered(K, m) == Approx(CGAL::to_double(1 - sum)).epsilon(1e-9).margin(2e-16));
}

TEST_CASE("strong occlusion model: P1 <= P2, both fall with K and with the ratio", "[methods][model][law]")
{
  Random random(21);
  for (int trial = 0; trial < 300; ++trial) {
    double const m = random.chance(0.5) ? random.uniform(0.02, 1) : random.uniform(1, 9), more = m * 1.01;
    int const K = random.below(random.chance(0.5) ? 10 : 400);
    CAPTURE(m, K);
    double const slack = 1 + 1e-12;
    REQUIRE(plane::uncovered(K, m) <= plane::not_strongly_occluded(K, m) * slack);
    REQUIRE(plane::uncovered(K, m) >= 0);
    REQUIRE(plane::uncovered(K + 1, m) <= plane::uncovered(K, m) * slack);
    REQUIRE(plane::uncovered(K, more) <= plane::uncovered(K, m) * slack);
    REQUIRE(plane::uncovered_poisson(K, m) <= plane::not_strongly_occluded_poisson(K, m) * slack);
    REQUIRE(plane::uncovered_poisson(K + 0.1, m) <= plane::uncovered_poisson(K, m) * slack);
    REQUIRE(plane::uncovered_poisson(K, more) <= plane::uncovered_poisson(K, m) * slack);
    // Gaps are negatively associated: covered with probability at most e^-(expected gaps).
    REQUIRE(plane::uncovered(K, m) * slack >= -std::expm1(-plane::expected_gaps(K, m)));
    REQUIRE(plane::uncovered(K, m) <= plane::expected_gaps(K, m) * slack);
    REQUIRE(space::not_strongly_occluded(K, more) <= space::not_strongly_occluded(K, m) * slack);
    REQUIRE(plane::not_strongly_occluded(K, m) <= space::not_strongly_occluded(K, m) * slack);
  }
}

TEST_CASE("strong occlusion model: limits", "[methods][model][law]")
{
  for (double const m : {0.01, 0.7, 1.0, 4.0}) {
    REQUIRE(plane::uncovered(0, m) == 1);
    REQUIRE(plane::uncovered_poisson(0, m) == 1);
    REQUIRE(plane::not_strongly_occluded(0, m) == 1);
    REQUIRE(space::not_strongly_occluded_poisson(0, m) == 1);
  }
  for (int const K : {1, 7, 50}) {  // the two forms meet at m = 1
    REQUIRE(plane::uncovered(K, std::nextafter(1.0, 0.0)) == Approx(plane::uncovered(K, 1)));
    REQUIRE(plane::uncovered_poisson(K, std::nextafter(1.0, 0.0)) == Approx(plane::uncovered_poisson(K, 1)));
    REQUIRE(plane::not_strongly_occluded(K, 1) == 1);
    REQUIRE(space::not_strongly_occluded(K, 1) == 1);
    REQUIRE(plane::uncovered(K, 1e-6) == 1);  // a few specks cover nothing
  }
  // A cell as large as the balls: nothing is strongly occluded; near it the numbers grow without bound.
  REQUIRE(std::isinf(plane::conservatively_visible_estimate(0.5, 0.5, 0)));
  REQUIRE(std::isinf(space::conservatively_visible_estimate(0.5, 0.6, 0)));
  REQUIRE(std::isinf(plane::conservatively_visible_poisson(0.5, 0.5)));
  REQUIRE(std::isfinite(plane::visible_estimate(0.5, 0.7, 0)));
  double const close = 0.5 * (1 - 1e-9);
  REQUIRE(plane::conservatively_visible_estimate(0.5, close, 0) ==
          Approx(pi / 2 / std::pow(0.5 * 2.5e-10, 2)).epsilon(1e-6));  // rate^2 M^2 with M ~ (m - 1) / 2
  // A point: a constant, not zero.
  double const point = plane::visible_estimate(0.5, 0, 0);
  REQUIRE(point > 10);
  REQUIRE(plane::visible_estimate(0.5, 1e-9, 0) == Approx(point));
  // The examples of 4.2: P2-hat decays like 2^-K for m = 3 in the plane, m = 3 + 2 sqrt 2 in space.
  REQUIRE(plane::not_strongly_occluded(1, 3) == Approx(0.5));
  REQUIRE(space::not_strongly_occluded(1, 3 + 2 * std::numbers::sqrt2) == Approx(0.5));
  REQUIRE(space::not_strongly_occluded(1, 6) < 0.5);
}

TEST_CASE("strong occlusion model: fixing K at its mean underestimates P2, and P1 but for few occluders",
          "[methods][model][law]")
{
  for (double const m : {1.0, 1.3, 2.0, 3.5, 3.9, 3.95, 5.0, 20.0}) {
    CAPTURE(m);
    bool above = false, below = false;
    for (double K = 1e-4; K < 40; K *= 1.01) {
      REQUIRE(plane::not_strongly_occluded_poisson(K, m) >= plane::not_strongly_occluded(K, m) * (1 - 1e-12));
      REQUIRE(space::not_strongly_occluded_poisson(K, m) >= space::not_strongly_occluded(K, m) * (1 - 1e-12));
      bool const more = plane::uncovered_poisson(K, m) > plane::expected_gaps(K, m);
      if (above) REQUIRE(more);  // one change of sign at most
      (more ? above : below) = true;
    }
    REQUIRE(above);
    REQUIRE(below == (std::log1p(m) < 2 * m / (1 + m)));
  }
}

TEST_CASE("strong occlusion model: arguments out of their domain are refused", "[methods][model]")
{
  double const nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (double const bad : {-1.0, nan, inf}) {
    CAPTURE(bad);
    REQUIRE_THROWS_AS(plane::potential_occluders(bad, 0.1, 1), std::invalid_argument);
    REQUIRE_THROWS_AS(plane::potential_occluders(0.5, bad, 1), std::invalid_argument);
    REQUIRE_THROWS_AS(plane::potential_occluders(0.5, 0.1, bad), std::invalid_argument);
    REQUIRE_THROWS_AS(space::potential_occluders(0.5, 0.1, 1, bad), std::invalid_argument);
    REQUIRE_THROWS_AS(plane::uncovered(3, bad), std::invalid_argument);
    REQUIRE_THROWS_AS(plane::uncovered_poisson(bad, 2), std::invalid_argument);
    REQUIRE_THROWS_AS(space::uncovered_at_most_poisson(bad, 2), std::invalid_argument);
    REQUIRE_THROWS_AS(space::not_strongly_occluded(bad, 2), std::invalid_argument);
    REQUIRE_THROWS_AS(plane::visible_estimate(0.5, 0.1, bad), std::invalid_argument);
    REQUIRE_THROWS_AS(model::size_ratio(0.5, bad), std::invalid_argument);
  }
  REQUIRE_THROWS_AS(plane::uncovered(-1, 2), std::invalid_argument);
  REQUIRE_THROWS_AS(space::uncovered_at_least(-1, 2), std::invalid_argument);
  REQUIRE_THROWS_AS(model::size_ratio(0.5, 0), std::invalid_argument);
  REQUIRE_THROWS_AS(plane::visible_poisson(0.5, 0.6), std::invalid_argument);
  REQUIRE_THROWS_AS(space::equivalent_half_width(0.5, 0.6), std::invalid_argument);
}
