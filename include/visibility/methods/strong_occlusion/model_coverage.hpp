#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>

/// Coverage of an interval by random intervals of equal length: the sums of Theorem 2 of
/// proofs/strong_occlusion_model.md, which alternate and cancel when many short intervals cover a long one.
namespace visibility::strong_occlusion::model::coverage {

/// 160 decimal digits: the sums below lose at most 88 of them (Theorem 2, "Evaluation").
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<160>, boost::multiprecision::et_off>;

inline Wide power(Wide base, unsigned exponent)
{
  Wide result = 1;
  for (; exponent > 0; exponent /= 2, base *= base)
    if (exponent % 2 == 1) result *= base;
  return result;
}

/// Sum over j = 1, 2, ... of (-1)^(j+1) term(j), for terms that rise and then fall; term(j) = 0 ends it.
template <class Term>
double alternating_sum(Term const& term)
{
  constexpr double far_below_double = 1e-20;  // a share of the sum
  Wide sum = 0, last = 0;
  for (unsigned j = 1;; ++j) {
    Wide const t = term(j);
    if (t == 0) break;
    sum += j % 2 == 1 ? t : -t;
    if (t < last && t < abs(sum) * far_below_double) break;  // what remains is less than the last term
    last = t;
  }
  return std::clamp(static_cast<double>(sum), 0.0, 1.0);
}

/// Requires: occluders >= 0, ratio > 0.
inline double uncovered(int occluders, double ratio)
{
  auto const n = static_cast<unsigned>(occluders);
  double const gaps = (n + 1.0) * std::exp(-(n * std::log1p(ratio)));
  if (ratio >= 1) return std::min(gaps, 1.0);
  if (gaps > 40) return 1;  // covered with probability at most e^-40
  Wide binomial = 1;        // of n + 1 over j
  return alternating_sum([&](unsigned j) -> Wide {
    Wide const room = 1 - Wide(j - 1) * ratio;
    if (j > n + 1 || room <= 0) return 0;
    binomial = binomial * (n + 2 - j) / j;
    return binomial * power(room / (1 + Wide(ratio)), n);
  });
}

/// Requires: mean >= 0, ratio > 0.
inline double uncovered_poisson(double mean, double ratio)
{
  double const long_spacing = std::exp(-mean * (ratio / (1 + ratio)));
  double const inner = mean / (1 + ratio);
  if (ratio >= 1) return long_spacing * (1 + inner);
  if (inner * long_spacing > 200) return 1;  // covered with probability at most 2 e^-40
  Wide const spacing = exp(-Wide(mean) * ratio / (1 + Wide(ratio)));
  Wide decay = 1, factorial = 1;  // spacing^j, (j - 1)!
  return alternating_sum([&](unsigned j) -> Wide {
    Wide const room = 1 - Wide(j - 1) * ratio;
    if (room <= 0) return 0;
    decay *= spacing;
    if (j > 1) factorial *= j - 1;
    Wide const x = Wide(mean) * room / (1 + Wide(ratio));
    return decay * power(x, j - 1) / factorial * (1 + x / j);
  });
}

}  // namespace visibility::strong_occlusion::model::coverage
