#pragma once

#include "visibility/kernel/layers.hpp"
#include "visibility/kernel/tally.hpp"

#include <concepts>
#include <string_view>

namespace visibility {

/// Exact and fast: a proved floating-point filter, then intervals, then exact numbers. The default everywhere.
/// `Tally` counts which layer decided (kernel/tally.hpp).
template <class Tally>
struct BasicFiltered {
  static constexpr std::string_view name = "filtered";
  static constexpr bool is_exact = true;
  template <class Formula, std::same_as<double>... X>
  static Sign sign(Formula const& f, X... x)
  {
    if (auto const s = layers::filter(f, x...)) return Tally::count(Layer::filter), *s;
    if (auto const s = layers::interval(f, x...)) return Tally::count(Layer::interval), *s;
    return Tally::count(Layer::exact), layers::exact(f, x...);
  }
};
using Filtered = BasicFiltered<NoTally>;
using TalliedFiltered = BasicFiltered<ThreadTally>;

/// Exact without a filter: the reference. Also takes rational coordinates.
struct Rational {
  static constexpr std::string_view name = "rational";
  static constexpr bool is_exact = true;
  template <class Formula, class... X>
  static Sign sign(Formula const& f, X const&... x)
  {
    RationalNumber const value = f(RationalNumber(x)...);
    return static_cast<Sign>(static_cast<int>(CGAL::sign(value)));
  }
};

/// Plain floating point: no guarantee, kept for comparison.
struct Double {
  static constexpr std::string_view name = "double";
  static constexpr bool is_exact = false;
  template <class Formula, std::same_as<double>... X>
  static Sign sign(Formula const& f, X... x)
  {
    return sign_of(f(x...));
  }
};

namespace detail {
struct DifferenceFormula {
  template <class T>
  auto operator()(T const& a, T const& b) const
  {
    return a - b;
  }
};
}  // namespace detail

/// What every algorithm of the library is a template over.
template <class A>
concept Arithmetic = requires(double x)
{
  {
    A::sign(detail::DifferenceFormula{}, x, x)
    } -> std::same_as<Sign>;
  {
    A::name
    } -> std::convertible_to<std::string_view>;
  {
    A::is_exact
    } -> std::convertible_to<bool>;
};
static_assert(Arithmetic<Filtered> && Arithmetic<TalliedFiltered> && Arithmetic<Rational> && Arithmetic<Double>);
static_assert(!Arithmetic<int>);

}  // namespace visibility
