#pragma once

#include "visibility/line_space/plucker_line.hpp"

#include <CGAL/Gmpz.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

/// Scaling of Plücker vectors by positive numbers, which keeps rays and half-spaces as they are, so that the numbers
/// stay small: an incremental cone without it squares its numbers with every half-space.
namespace visibility {

namespace detail {

/// Divides integers by their greatest common divisor (of `CGAL::Mpzf`: of the mantissas).
template <class NT>
void divide_by_gcd(PluckerLine<NT>& l)
{
  using Traits = CGAL::Algebraic_structure_traits<NT>;
  NT divisor(0);
  for (std::size_t i = 0; i < 6; ++i) {
    if (is_zero(number_sign(l[i]))) continue;
    divisor = is_zero(number_sign(divisor)) ? magnitude(l[i]) : magnitude<NT>(typename Traits::Gcd{}(divisor, l[i]));
    if (divisor == NT(1)) return;
  }
  for (std::size_t i = 0; i < 6; ++i)
    if (!is_zero(number_sign(l[i]))) l[i] = typename Traits::Integral_division{}(l[i], divisor);
}

}  // namespace detail

/// Scales the components to small ones: coprime integers (Gmpz, Gmpq), integers times powers of two whose mantissas are
/// coprime (Mpzf). A zero vector stays.
template <class NT>
void make_primitive(PluckerLine<NT>& l)
{
  detail::divide_by_gcd(l);
}

#ifdef CGAL_HAS_MPZF
/// A greatest common divisor of Mpzf leaves powers of two alone, and products would double the exponent every time; so
/// where the largest component is far from 1, it is brought near.
inline void make_primitive(PluckerLine<CGAL::Mpzf>& l)
{
  detail::divide_by_gcd(l);
  if (is_zero(l)) return;
  for (;;) {
    double largest = 0;
    for (std::size_t i = 0; i < 6; ++i) largest = std::max(largest, std::fabs(CGAL::to_double(l[i])));
    if (0x1p-640 < largest && largest < 0x1p640) return;
    int const step = largest == 0 ? 960 : std::isinf(largest) ? -960 : -(std::ilogb(largest) / 64 * 64);
    CGAL::Mpzf const factor(std::ldexp(1.0, std::clamp(step, -960, 960)));
    for (std::size_t i = 0; i < 6; ++i) l[i] = l[i] * factor;
  }
}
#endif

inline void make_primitive(PluckerLine<CGAL::Gmpq>& l)
{
  CGAL::Gmpz denominator(1), divisor(0);
  for (std::size_t i = 0; i < 6; ++i) {
    CGAL::Gmpz const d = l[i].denominator();
    denominator = denominator * CGAL::integral_division(d, CGAL::gcd(denominator, d));
  }
  for (std::size_t i = 0; i < 6; ++i) {
    l[i] *= CGAL::Gmpq(denominator);
    divisor = CGAL::gcd(divisor, l[i].numerator());
  }
  if (divisor == 0 || divisor == 1) return;
  for (std::size_t i = 0; i < 6; ++i) l[i] = CGAL::Gmpq(CGAL::integral_division(l[i].numerator(), divisor));
}

/// By a power of two, so that the largest component is in [1/2, 1): no rounding but of subnormal numbers.
inline void make_primitive(PluckerLine<double>& l)
{
  double largest = 0;
  for (std::size_t i = 0; i < 6; ++i) largest = std::max(largest, std::fabs(l[i]));
  if (largest == 0 || !std::isfinite(largest)) return;
  int const exponent = std::ilogb(largest) + 1;
  for (std::size_t i = 0; i < 6; ++i) l[i] = std::scalbn(l[i], -exponent);
}

/// `l` after `make_primitive`.
template <class NT>
PluckerLine<NT> primitive(PluckerLine<NT> l)
{
  make_primitive(l);
  return l;
}

/// The binary exponent of the largest component; none for the zero vector and where a double cannot hold it.
template <class NT>
std::optional<int> size_exponent(PluckerLine<NT> const& l)
{
  double largest = 0;
  for (std::size_t i = 0; i < 6; ++i) largest = std::max(largest, std::fabs(CGAL::to_double(l[i])));
  return largest > 0 && std::isfinite(largest) ? std::optional(std::ilogb(largest)) : std::nullopt;
}

/// Multiplies the smaller ones by powers of two so that all have about the same size, where doubles can tell: their sum
/// then lies well inside of their hull. A choice; any scale is right.
template <class NT>
void make_comparable(std::span<PluckerLine<NT>> lines)
{
  std::optional<int> largest;  // the exponent
  for (auto const& l : lines)
    if (auto const e = size_exponent(l)) largest = std::max(largest.value_or(*e), *e);
  for (auto& l : lines)
    if (auto const e = size_exponent(l); e && *e < *largest && *largest - *e < 1000) {
      NT const factor(std::ldexp(1.0, *largest - *e));
      for (std::size_t i = 0; i < 6; ++i) l[i] = l[i] * factor;
    }
}

}  // namespace visibility
