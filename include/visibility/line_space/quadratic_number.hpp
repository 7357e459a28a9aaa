#pragma once

#include "visibility/kernel/number_types.hpp"
#include "visibility/kernel/sign.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace visibility {

/// Sign of p + q sqrt(d). Requires: d >= 0. Exact for exact number types: ring operations only.
template <class NT>
Sign sign_with_root(NT const& p, NT const& q, NT const& d)
{
  Sign const sp = sign_of(p), sq = sign_of(d) == Sign::zero ? Sign::zero : sign_of(q);
  if (sp == sq || is_zero(sq)) return sp;
  if (is_zero(sp)) return sq;
  return sp * sign_of(NT(p * p - q * q * d));
}

/// Sign of p + q sqrt(d) + r sqrt(e). Requires: d, e >= 0. Exact for exact number types: ring operations only.
template <class NT>
Sign sign_with_roots(NT const& p, NT const& q, NT const& d, NT const& r, NT const& e)
{
  Sign const a = sign_with_root(p, q, d), b = sign_of(e) == Sign::zero ? Sign::zero : sign_of(r);
  if (a == b || is_zero(b)) return a;
  if (is_zero(a)) return b;
  // Opposite signs: compare the squares.
  return a * sign_with_root(NT(p * p + q * q * d - r * r * e), NT(NT(2) * p * q), d);
}

/// The number (p + q sqrt(d)) / r. Invariant: r > 0, d >= 0.
template <class NT>
struct QuadraticNumber {
  NT p, q, d, r;

  static QuadraticNumber fraction(NT const& numerator, NT const& denominator)
  {
    if (is_negative(sign_of(denominator))) return {NT(0) - numerator, NT(0), NT(0), NT(0) - denominator};
    return {numerator, NT(0), NT(0), denominator};
  }
  static QuadraticNumber integer(int n) { return {NT(n), NT(0), NT(0), NT(1)}; }
};

/// The nearest double but for a few roundings: for people to look at.
inline double approximate(QuadraticNumber<RationalNumber> const& x)
{
  return (CGAL::to_double(x.p) + CGAL::to_double(x.q) * std::sqrt(CGAL::to_double(x.d))) / CGAL::to_double(x.r);
}

template <class NT>
Sign compare(QuadraticNumber<NT> const& a, QuadraticNumber<NT> const& b)
{
  return sign_with_roots(NT(a.p * b.r - b.p * a.r), NT(a.q * b.r), a.d, NT(NT(0) - b.q * a.r), b.d);
}

/// The real roots of a x^2 + b x + c, ascending; a double root once. Requires: not all coefficients zero.
template <class NT>
std::pair<std::optional<QuadraticNumber<NT>>, std::optional<QuadraticNumber<NT>>> real_roots(NT a, NT b, NT c)
{
  using Number = QuadraticNumber<NT>;
  if (is_zero(sign_of(a))) {
    if (is_zero(sign_of(b))) return {};
    return {Number::fraction(NT(0) - c, b), std::nullopt};
  }
  if (is_negative(sign_of(a))) a = NT(0) - a, b = NT(0) - b, c = NT(0) - c;
  NT const d = b * b - NT(4) * a * c, twice = NT(2) * a, minus_b = NT(0) - b;
  switch (sign_of(d)) {
  case Sign::negative: return {};
  case Sign::zero: return {Number{minus_b, NT(0), NT(0), twice}, std::nullopt};
  case Sign::positive: break;
  }
  return {Number{minus_b, NT(-1), d, twice}, Number{minus_b, NT(1), d, twice}};
}

}  // namespace visibility
