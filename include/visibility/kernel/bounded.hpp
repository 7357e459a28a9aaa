#pragma once

#include "visibility/kernel/sign.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <concepts>

/// Floating-point numbers that carry a proved error bound through a formula; the filter layer of every predicate.
///
/// A formula is written once, over any number type. Evaluated on these types it computes in plain double and, beside
/// the value v, a magnitude m, while the type counts roundings: an expression of type with parameter K satisfies
///     |v - t| <= ((1 + u)^K - 1) m   and   |v| <= m,      t the exact value, u = 2^-53,
/// for all finite inputs, underflow included; after an overflow m is infinite or NaN and nothing is certified.
/// Requires: IEEE double, round to nearest, gradual underflow, no contraction (the build sees to all of these).
/// Proof: proofs/filters.md (Theorem 1); tests/proofs/bounds_test.cpp recomputes the constants.
namespace visibility::bounded {

static_assert(FLT_EVAL_METHOD == 0,
              "double arithmetic must round to double: on x86-32 compile with -msse2 -mfpmath=sse");
#ifdef __FAST_MATH__
#error "the error bounds do not hold under -ffast-math"
#endif

inline constexpr double u = 0x1p-53;                 ///< unit roundoff, round to nearest
inline constexpr double underflow_guard = 0x1p-960;  ///< swallows the absolute error of underflowing products

/// An input (K = 0) or a sum or difference of two inputs (K = 1, never an underflow error): m = |v|.
template <int K>
struct Leaf {
  static constexpr int roundings = K;
  double v;
  double magnitude() const { return std::fabs(v); }
};

/// A product of two leaves; only an underflow keeps its error from being relative: m = |v| + guard.
template <int K>
struct Product {
  static constexpr int roundings = K;
  double v;
  double magnitude() const { return std::fabs(v) + underflow_guard; }
};

/// Anything else: m is computed beside v.
template <int K>
struct Sum {
  static constexpr int roundings = K;
  double v;
  double m;
  double magnitude() const { return m; }
};

template <class T>
concept Number = requires(T const& x)
{
  {
    T::roundings
    } -> std::convertible_to<int>;
  x.v;
  x.magnitude();
};

using Input = Leaf<0>;

inline Leaf<1> operator+(Leaf<0> a, Leaf<0> b) { return {a.v + b.v}; }
inline Leaf<1> operator-(Leaf<0> a, Leaf<0> b) { return {a.v - b.v}; }

template <int I, int J>
Product<I + J + 1> operator*(Leaf<I> a, Leaf<J> b)
{
  return {a.v * b.v};
}

template <Number A, Number B>
auto operator+(A const& a, B const& b)
{
  return Sum<std::max(A::roundings, B::roundings) + 1>{a.v + b.v, a.magnitude() + b.magnitude()};
}

template <Number A, Number B>
auto operator-(A const& a, B const& b)
{
  return Sum<std::max(A::roundings, B::roundings) + 1>{a.v - b.v, a.magnitude() + b.magnitude()};
}

template <Number A, Number B>
auto operator*(A const& a, B const& b)
{
  return Sum<A::roundings + B::roundings + 1>{a.v * b.v, a.magnitude() * b.magnitude() + underflow_guard};
}

/// (1 + u)^K - 1 rounded up with room for the rounding of the product with m. Requires: 0 <= K <= 1000.
template <int K>
inline constexpr double relative_bound = (K + 2 + K * K * u) * u;

/// The sign of the exact value where the bound certifies it; never certifies zero.
template <Number A>
MaybeSign certified_sign(A const& a)
{
  double const bound = relative_bound<A::roundings> * a.magnitude();
  if (a.v > bound) return Sign::positive;
  if (a.v < -bound) return Sign::negative;
  return {};
}

}  // namespace visibility::bounded
