#pragma once

#include "visibility/methods/strong_occlusion/model_common.hpp"
#include "visibility/methods/strong_occlusion/model_coverage.hpp"

#include <numbers>

/// The model in the plane: balls are circles, the cell seen from the target is a segment of half length `cell`.
namespace visibility::strong_occlusion::model::plane {

inline constexpr double paper_density = 1.0 / 4;  ///< one circle per 2 x 2 square

namespace detail {

using namespace model::detail;

/// What the integrals of the paper need.
struct Rates {
  double per_distance;  ///< the paper's b-bar: expected occluders per unit of distance
  double visible;       ///< ln(m + 1)
  double conservative;  ///< ln((m + 1) / 2), positive iff cell < R
};

/// Requires valid sizes. Logarithms keep their digits as cell -> R.
inline Rates rates(double radius, double cell)
{
  double const larger = (radius - cell) / (radius + cell);  // m - 1
  return {(3 * radius + cell) / 4, std::log1p(1 + larger), std::log1p(larger / 2)};
}

}  // namespace detail

/// K: expected number of balls between cell and target, those with centres in the trapezoid with bases
/// 2 (cell + R), 4 R and height `distance`: density (3 R + cell) distance. [CohenOr98, (1)]; page, Lemma 1.
inline double potential_occluders(double radius, double cell, double distance, double density = paper_density)
{
  detail::require_sizes(radius, cell);
  detail::require_distance(distance);
  detail::require_density(density);
  return density * (3 * radius + cell) * distance;
}

/// Expected number of discs that meet the closed trapezoid with bases 2 cell and 2 R: density times the area of its
/// parallel body. More than `potential_occluders`, by a bounded amount; page, Lemma 1.
inline double discs_meeting_trapezoid(double radius, double cell, double distance, double density = paper_density)
{
  double const inner = potential_occluders(radius, cell, distance, density);
  double const slanted = std::hypot(distance, radius - cell) - distance;
  return inner + density * radius * (2 * slanted + 2 * cell + (2 + std::numbers::pi) * radius);
}

/// Expected number of strong occluders if balls are replaced by their diameters across the shaft: density
/// (R - cell) distance, 0 for cell >= R. Page, Theorem 4.
inline double strong_occluders(double radius, double cell, double distance, double density = paper_density)
{
  detail::require_sizes(radius, cell);
  detail::require_distance(distance);
  detail::require_density(density);
  return density * std::fmax(radius - cell, 0) * distance;
}

/// Probability that a given line of length `distance` meets no ball of a Poisson scene (balls replaced by their
/// diameters across it): e^(-2 R density distance). The rate at which visibility decays; page, Theorem 4.
inline double line_unobstructed(double radius, double distance, double density = paper_density)
{
  detail::require_sizes(radius, 0);
  detail::require_distance(distance);
  detail::require_density(density);
  return std::exp(-2 * radius * density * distance);
}

/// P1-hat: probability that K intervals of half length R, centres uniform among those that touch [-b, b], do not cover
/// it, for any ratio R / b > 0. (K+1) (1/(ratio+1))^K for ratio >= 1, an alternating sum below; page, Theorem 2.
inline double uncovered(int occluders, double ratio)
{
  detail::require_count(occluders);
  detail::require_ratio(ratio);
  return coverage::uncovered(occluders, ratio);
}

/// The same averaged over K with Poisson distribution of the given mean, in closed form; page, Theorem 2.
inline double uncovered_poisson(double mean_occluders, double ratio)
{
  detail::require_count(mean_occluders);
  detail::require_ratio(ratio);
  return coverage::uncovered_poisson(mean_occluders, ratio);
}

/// (K+1) (1/(ratio+1))^K, the printed P1-hat [CohenOr98, Lemma 4.1]. What it is for every ratio: the expected number of
/// gaps that K intervals leave in [-b, b]; the probability of a gap iff ratio >= 1 or K = 0. Takes real K as the
/// paper's integrals do, where it may exceed 1. Page, Theorem 2.
inline double expected_gaps(double occluders, double ratio)
{
  detail::require_count(occluders);
  detail::require_ratio(ratio);
  return (occluders + 1) * std::exp(-occluders * std::log1p(ratio));
}

/// P2-hat: probability that none of K such intervals covers [-b, b] alone: (2/(ratio+1))^K for ratio >= 1, else 1.
/// [CohenOr98, Lemma 4.1]; page, Lemma 3.
inline double not_strongly_occluded(double occluders, double ratio)
{
  detail::require_count(occluders);
  detail::require_ratio(ratio);
  return ratio <= 1 ? 1.0 : std::exp(-occluders * std::log1p((ratio - 1) / 2));
}

/// The same averaged over K with Poisson distribution of the given mean; page, Lemma 3.
inline double not_strongly_occluded_poisson(double mean_occluders, double ratio)
{
  detail::require_count(mean_occluders);
  detail::require_ratio(ratio);
  return ratio <= 1 ? 1.0 : std::exp(-mean_occluders * (ratio - 1) / (ratio + 1));
}

/// The paper's expression for N_vis, the number of visible balls, all within r0 of the cell counted as visible, with
/// b = (R + cell) / 2 and one ball per 2 x 2. The paper calls it an upper bound; it is none (page, section 6).
inline double visible_estimate(double radius, double cell, double r0)
{
  detail::require_sizes(radius, cell);
  detail::require_distance(r0);
  auto const [rate, decay, unused] = detail::rates(radius, cell);
  double const from = rate * r0;
  double const far = detail::tail_integral(2, decay, from) + detail::tail_integral(1, decay, from);
  return std::numbers::pi * (detail::square(cell + r0) / 4 + far / (2 * rate * rate));
}

/// The paper's expression for N_c-vis, the number of balls without strong occluder, with ln^2 where the text has ln;
/// infinite for cell >= R. As above, no bound; page, Lemma 6.
inline double conservatively_visible_estimate(double radius, double cell, double r0)
{
  detail::require_sizes(radius, cell);
  detail::require_distance(r0);
  auto const [rate, unused, decay] = detail::rates(radius, cell);
  double const far = detail::tail_integral(1, decay, rate * r0);
  return std::numbers::pi * (detail::square(cell + r0) / 4 + far / (2 * rate * rate));
}

/// The r0 >= 0 that makes `visible_estimate` least: 0, except for balls far smaller than their spacing and cells of
/// about their size, where the integrand exceeds 1. For `conservatively_visible_estimate` it is always 0. Lemma 7.
inline double best_radius(double radius, double cell)
{
  detail::require_sizes(radius, cell);
  auto const [rate, L, unused] = detail::rates(radius, cell);
  if (L >= 1) return 0;
  // d/dr0 has the sign of `slope`, which falls and then rises in x = rate r0; page, Lemma 7.
  double const decay = L;
  auto const slope = [=, start = rate * cell](double x) { return start + x - x * (x + 1) * std::exp(-decay * x); };
  auto const curved = [=](double x) { return 1 - std::exp(-decay * x) * (2 * x + 1 - decay * (x * x + x)); };
  auto const root = [](auto const& f, double below, double above) {
    for (int i = 0; i < 200; ++i) (f((below + above) / 2) < 0 ? below : above) = (below + above) / 2;
    return above;
  };
  double const spread = std::sqrt(decay * decay + 8);
  double const least = root(curved, (4 - decay - spread) / (2 * decay), (4 - decay + spread) / (2 * decay));
  if (slope(least) >= 0) return 0;
  double above = 2 * least;
  while (slope(above) < 0) above *= 2;
  double const r0 = root(slope, least, above) / rate;
  return visible_estimate(radius, cell, r0) < visible_estimate(radius, cell, 0) ? r0 : 0;
}

/// Expected number of balls of a Poisson scene, outside the square cell or in it, for which the shaft model finds no
/// strong occluder: all radii from 0, perimeter 8 cell + 2 pi r, infinite for cell >= R. Page, Theorem 5.
inline double conservatively_visible_poisson(double radius, double cell, double density = paper_density)
{
  double const rate = strong_occluders(radius, cell, 1, density);
  using detail::tail_integral;
  return density *
         (4 * cell * cell + 8 * cell * tail_integral(0, rate, 0) + 2 * std::numbers::pi * tail_integral(1, rate, 0));
}

/// The same for balls that some line of the shaft reaches (a subset of the visible ones): with probability
/// (1 + density (R + cell) r) e^(-2 density R r) at distance r. Requires cell <= R. Page, Theorem 5.
inline double visible_poisson(double radius, double cell, double density = paper_density)
{
  detail::require_sizes(radius, cell);
  detail::require_density(density);
  detail::require(cell <= radius, "model: visible_poisson needs a cell that is not larger than the balls");
  double const rate = 2 * density * radius, more = density * (radius + cell);
  auto const moment = [=](int n) { return detail::tail_integral(n, rate, 0); };
  return density * (4 * cell * cell + 8 * cell * (moment(0) + more * moment(1)) +
                    2 * std::numbers::pi * (moment(1) + more * moment(2)));
}

}  // namespace visibility::strong_occlusion::model::plane
