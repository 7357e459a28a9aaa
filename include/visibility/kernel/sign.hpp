#pragma once

#include <cstdint>
#include <optional>

namespace visibility {

/// Sign of a real number. `zero` is a proven equality, never "unknown".
enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

/// What one layer of a staged predicate says; empty: this layer cannot certify a sign.
using MaybeSign = std::optional<Sign>;

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<std::int8_t>(s)); }

/// Sign of a product whose factors have the signs a and b.
constexpr Sign operator*(Sign a, Sign b)
{
  return static_cast<Sign>(static_cast<std::int8_t>(a) * static_cast<std::int8_t>(b));
}

constexpr bool is_positive(Sign s) { return s == Sign::positive; }
constexpr bool is_negative(Sign s) { return s == Sign::negative; }
constexpr bool is_zero(Sign s) { return s == Sign::zero; }

/// Sign of a number that compares with an integer zero. NaN (plain `Double` arithmetic after an overflow) gives zero.
template <class NT>
constexpr Sign sign_of(NT const& x)
{
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

}  // namespace visibility
