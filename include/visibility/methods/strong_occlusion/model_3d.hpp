#pragma once

#include "visibility/methods/strong_occlusion/model_common.hpp"

#include <algorithm>
#include <numbers>

/// The model in space: the cell seen from the target is a disc of radius `cell`, the shaft a truncated cone, occluders
/// are their great discs across it.
namespace visibility::strong_occlusion::model::space {

inline constexpr double paper_density = 1.0 / 8;  ///< one ball per 2 x 2 x 2 cube

namespace detail {

using namespace model::detail;

inline void require_shaft(double radius, double cell, double distance, double density)
{
  require_sizes(radius, cell);
  require_distance(distance);
  require_density(density);
}

/// Chance that one of the discs covers a given point of B_b, and that it covers all of B_b.
inline double covers_point(double ratio) { return square(ratio / (1 + ratio)); }
inline double covers_all(double ratio) { return ratio <= 1 ? 0.0 : square((ratio - 1) / (ratio + 1)); }
/// Chance that a disc lies in the interior of B_b.
inline double lies_inside(double ratio) { return ratio >= 1 ? 0.0 : square((1 - ratio) / (1 + ratio)); }
/// Chance that the boundary of one disc crosses that of B_b; expected crossings of two discs' boundaries in B_b.
inline double crosses_rim(double ratio) { return 4 * ratio / square(1 + ratio); }
inline double crossings(double ratio) { return 8 * square(ratio) / square(square(1 + ratio)); }

/// Chance that one disc covers neither of two opposite points of the rim of B_b.
inline double misses_both(double ratio)
{
  double const h = 1 / ratio;  // half the distance of the points, radius 1
  double const both = h >= 1 ? 0.0 : 2 * (std::acos(h) - h * std::sqrt((1 - h) * (1 + h))) / std::numbers::pi;
  return std::max(0.0, 1 - (2 - both) * covers_point(ratio));
}

}  // namespace detail

/// K: expected number of balls between cell and target, those with centres in the truncated cone with radii cell + R
/// and 2 R: density pi/3 (7 R^2 + 4 cell R + cell^2) distance. [CohenOr98, 4.2]; page, Lemma 1.
inline double potential_occluders(double radius, double cell, double distance, double density = paper_density)
{
  detail::require_shaft(radius, cell, distance, density);
  return density * std::numbers::pi / 3 * (7 * radius * radius + 4 * cell * radius + cell * cell) * distance;
}

/// Expected number of strong occluders among great discs across the shaft: density pi/3 (R - cell)^2 distance, 0 for
/// cell >= R. Page, Theorem 4.
inline double strong_occluders(double radius, double cell, double distance, double density = paper_density)
{
  detail::require_shaft(radius, cell, distance, density);
  return density * std::numbers::pi / 3 * detail::square(std::fmax(radius - cell, 0)) * distance;
}

/// The half width b with which the cylinder has as many strong occluders as the cone. At most
/// (R + cell) / 2, which therefore overestimates what is potentially visible. Requires cell <= R. Page, Theorem 4.
inline double equivalent_half_width(double radius, double cell)
{
  detail::require_sizes(radius, cell);
  detail::require(cell <= radius, "model: no cylinder is equivalent if the cell is larger than the balls");
  double const share = (radius - cell) / std::sqrt(7 * radius * radius + 4 * cell * radius + cell * cell);
  return radius * (1 - share) / (1 + share);
}

/// Probability that a given line of length `distance` meets no great disc across it of a Poisson scene.
inline double line_unobstructed(double radius, double distance, double density = paper_density)
{
  detail::require_shaft(radius, 0, distance, density);
  return std::exp(-std::numbers::pi * radius * radius * density * distance);
}

/// P2-hat: probability that none of K discs of radius R, centres uniform in B_(R+b), covers B_b:
/// (4 m/(1+m)^2)^K for m >= 1, else 1. [CohenOr98, Lemma 4.2], which omits the case m < 1; page, Lemma 3.
inline double not_strongly_occluded(double occluders, double ratio)
{
  detail::require_count(occluders);
  detail::require_ratio(ratio);
  return std::exp(occluders * std::log1p(-detail::covers_all(ratio)));
}

/// The same averaged over K with Poisson distribution of the given mean; page, Lemma 3.
inline double not_strongly_occluded_poisson(double mean_occluders, double ratio)
{
  detail::require_count(mean_occluders);
  detail::require_ratio(ratio);
  return std::exp(-mean_occluders * detail::covers_all(ratio));
}

/// Lower and upper bound of P1-hat, the probability that K such discs do not cover B_b; the paper gives none.
/// Lower: one of two opposite points of the rim is uncovered. Upper: by counting corners of uncovered regions. Both
/// decay like ((2m+1)/(m+1)^2)^K up to a polynomial in K. Page, Theorem 8.
inline double uncovered_at_least(int occluders, double ratio)
{
  detail::require_count(occluders);
  detail::require_ratio(ratio);
  return 2 * std::pow(1 - detail::covers_point(ratio), occluders) - std::pow(detail::misses_both(ratio), occluders);
}

inline double uncovered_at_most(int occluders, double ratio)
{
  detail::require_count(occluders);
  detail::require_ratio(ratio);
  double const n = occluders, free = 1 - detail::covers_point(ratio);
  double const rim = n * detail::crosses_rim(ratio) * std::pow(free, n - 1);
  double const corners = n * (n - 1) / 6 * detail::crossings(ratio) * std::pow(free, n - 2);
  double const bound = std::pow(detail::lies_inside(ratio), n) + rim + corners;
  return std::min(bound, not_strongly_occluded(n, ratio));
}

/// The same averaged over K with Poisson distribution of the given mean.
inline double uncovered_at_least_poisson(double mean, double ratio)
{
  detail::require_count(mean);
  detail::require_ratio(ratio);
  return 2 * std::exp(-mean * detail::covers_point(ratio)) - std::exp(-mean * (1 - detail::misses_both(ratio)));
}

inline double uncovered_at_most_poisson(double mean, double ratio)
{
  detail::require_count(mean);
  detail::require_ratio(ratio);
  double const edges = mean * detail::crosses_rim(ratio) + mean * mean / 6 * detail::crossings(ratio);
  double const bound =
    std::exp(-mean * (1 - detail::lies_inside(ratio))) + edges * std::exp(-mean * detail::covers_point(ratio));
  return std::min(bound, not_strongly_occluded_poisson(mean, ratio));
}

/// The analogue of the paper's N_c-vis: all balls within r0 counted, beyond it shells of 4 pi r^2 dr with
/// P2-hat(K(r)), b = (R + cell) / 2, one ball per 2 x 2 x 2. Infinite for cell >= R. Least for r0 = 0. Lemma 6.
inline double conservatively_visible_estimate(double radius, double cell, double r0)
{
  detail::require_distance(r0);
  double const rate = potential_occluders(radius, cell, 1);
  double const decay = -std::log1p(-detail::covers_all(size_ratio(radius, mean_half_width(radius, cell))));
  double const far = detail::tail_integral(2, decay, rate * r0) / detail::cube(rate);
  return std::numbers::pi * (detail::cube(cell + r0) / 6 + far / 2);
}

/// The analogue of N_vis with the upper bound of Theorem 8, averaged over Poisson K.
inline double visible_estimate(double radius, double cell, double r0)
{
  detail::require_distance(r0);
  double const rate = potential_occluders(radius, cell, 1);
  double const m = size_ratio(radius, mean_half_width(radius, cell));
  auto const tail = [=](int n, double decay) { return detail::tail_integral(n, decay, rate * r0); };
  double const covered = detail::covers_point(m);
  double const far = tail(2, 1 - detail::lies_inside(m)) + detail::crosses_rim(m) * tail(3, covered) +
                     detail::crossings(m) / 6 * tail(4, covered);
  return std::numbers::pi * (detail::cube(cell + r0) / 6 + far / (2 * detail::cube(rate)));
}

/// Expected number of balls of a Poisson scene without strong occluder in the shaft model: all radii from 0, cube of
/// side 2 cell with surface 24 cell^2 + 12 pi cell r + 4 pi r^2. Infinite for cell >= R. Page, Theorem 5.
inline double conservatively_visible_poisson(double radius, double cell, double density = paper_density)
{
  double const rate = strong_occluders(radius, cell, 1, density);
  using detail::tail_integral;
  double const outside = 24 * cell * cell * tail_integral(0, rate, 0) +
                         12 * std::numbers::pi * cell * tail_integral(1, rate, 0) +
                         4 * std::numbers::pi * tail_integral(2, rate, 0);
  return density * (8 * detail::cube(cell) + outside);
}

}  // namespace visibility::strong_occlusion::model::space
