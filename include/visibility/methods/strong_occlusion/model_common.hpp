#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

/// The probabilistic model of [CohenOr98, 4], derived afresh in proofs/strong_occlusion_model.md ("the page" below):
/// balls of one radius R scattered at random, a view cell of half side `cell` (the paper's epsilon), a target ball at
/// distance d. `plane` is the 2D case, `space` the 3D one. Plain doubles: a model needs no exactness.
///
/// Units. Lengths in any one unit; densities are balls per unit of area or volume. The paper's unit is half the side of
/// its grid cells: one ball per 2 x 2 (x 2), which the default densities say.
/// Errors. Every function throws std::invalid_argument for an argument that is not finite or out of its domain.
namespace visibility::strong_occlusion::model {

/// Half the width of the shaft from cell to target, as the paper takes it: (R + cell) / 2. In the plane this mean is
/// exact for Poisson scenes (page, Theorem 4); in space it is not, see `space::equivalent_half_width`.
double mean_half_width(double radius, double cell);
/// m_b = R / b. (The scanned text has R / h.) At least 1 iff one ball can cover the shaft.
double size_ratio(double radius, double half_width);

namespace detail {

inline void require(bool holds, char const* message)
{
  if (!holds) throw std::invalid_argument(message);
}
inline void require_sizes(double radius, double cell)
{
  require(std::isfinite(radius) && radius > 0, "model: the radius must be positive and finite");
  require(std::isfinite(cell) && cell >= 0, "model: the half side of the cell must be finite and not negative");
}
inline void require_count(double count)
{
  require(std::isfinite(count) && count >= 0, "model: the number of occluders must be finite and not negative");
}
inline void require_ratio(double ratio)
{
  require(std::isfinite(ratio) && ratio > 0, "model: the ratio of sizes must be positive and finite");
}
inline void require_density(double density)
{
  require(std::isfinite(density) && density > 0, "model: the density must be positive and finite");
}
inline void require_distance(double distance)
{
  require(std::isfinite(distance) && distance >= 0, "model: a distance must be finite and not negative");
}

inline double square(double x) { return x * x; }
inline double cube(double x) { return x * x * x; }

/// Integral of x^n e^(-rate x) over x >= from; infinite for rate <= 0. A sum of positive terms, so nothing cancels.
inline double tail_integral(int n, double rate, double from)
{
  if (rate <= 0) return std::numeric_limits<double>::infinity();
  double term = 1 / rate, sum = 0;  // n!/k! from^k / rate^(n-k+1), by Horner from the highest power down
  for (int k = n; k >= 0; --k) {
    sum += term * std::pow(from, k);
    term *= k / rate;
  }
  return sum * std::exp(-rate * from);
}

}  // namespace detail

inline double mean_half_width(double radius, double cell)
{
  detail::require_sizes(radius, cell);
  return radius / 2 + cell / 2;
}

inline double size_ratio(double radius, double half_width)
{
  detail::require_sizes(radius, half_width);
  detail::require(half_width > 0, "model: the half width of the shaft must be positive");
  return radius / half_width;
}

}  // namespace visibility::strong_occlusion::model
