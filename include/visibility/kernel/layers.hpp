#pragma once

#include "visibility/kernel/bounded.hpp"
#include "visibility/kernel/number_types.hpp"
#include "visibility/kernel/sign.hpp"
#include "visibility/kernel/structural_zero.hpp"

#include <cmath>
#include <concepts>

/// The layers that decide the sign of a formula: a callable `f(x...)` over any number type, a polynomial of degree at
/// most `max_degree` in its arguments, built from +, - and * only. No layer ever returns a wrong sign.
namespace visibility::layers {

inline constexpr int max_degree = 6;

/// A formula that knows input on which it vanishes whatever the numbers are (two equal points), and says so.
template <class Formula, class... X>
concept KnowsZeros = requires(X... x)
{
  {
    Formula::vanishes(x...)
    } -> std::same_as<bool>;
};

/// Error bound proved by type (kernel/bounded.hpp), then zeros that need no arithmetic: those that the formula knows,
/// and those that the pattern of zero differences proves (kernel/structural_zero.hpp).
template <class Formula, class... X>
MaybeSign filter(Formula const& f, X... x)
{
  if (auto const s = bounded::certified_sign(f(bounded::Input{x}...))) return s;
  if constexpr (KnowsZeros<Formula, X...>)
    if (Formula::vanishes(x...)) return Sign::zero;
  StructuralZero const pattern = f(StructuralInput{x}...);
  return pattern.zero ? MaybeSign{Sign::zero} : MaybeSign{};
}

/// Inputs up to this magnitude cannot overflow an interval formula of degree `max_degree` with at most 2^40 terms.
inline constexpr double interval_domain = 0x1p160;

/// Directed rounding; abstains outside the domain in which no bound can overflow.
template <class Formula, class... X>
[[gnu::noinline]] MaybeSign interval(Formula const& f, X... x)
{
  if (!((std::fabs(x) <= interval_domain) && ...)) return {};
  CGAL::Protect_FPU_rounding<true> const upward;
  IntervalNumber const value = f(IntervalNumber(x)...);
  if (value.inf() > 0) return Sign::positive;
  if (value.sup() < 0) return Sign::negative;
  if (value.inf() == 0 && value.sup() == 0) return Sign::zero;
  return {};
}

/// The truth, for all finite doubles.
template <class Formula, class... X>
[[gnu::noinline]] Sign exact(Formula const& f, X... x)
{
  ExactNumber const value = f(ExactNumber(x)...);
  return static_cast<Sign>(static_cast<int>(CGAL::sign(value)));
}

}  // namespace visibility::layers
