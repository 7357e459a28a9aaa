// How well the analytic model of strong occlusion (docs/strong-occlusion-model.md) describes scenes.
//
//   strong_occlusion_model_bench [scenes = 20] [balls along each side = 100] [viewpoints = 200]
//
// Input: `generate("circles,...")`, jittered grids of circles of radius 50 (R = 1/2 in units of half a grid cell) and
// 10 (R = 1/10), spacing 200, seeds 1, 2, ...; square cells in the middle of the free grid cell. Each circle is a
// target. Measured: the share without strong occluder, decided for true discs from the four corners of the cell (exact
// but for rounding); and the share seen from one of the viewpoints on the rim of the cell, each decided by the union of
// the shadows (a lower bound of what is visible from the cell). By distance from the cell, with the standard error over
// scenes. Model: b = (R + cell)/2, probabilities averaged over the same circles. "Corrected": Poisson, but the square
// cell is as wide as it looks from the circle, and no centre lies in the free grid cell. Table first, then one JSON
// object.

#include "visibility/methods/strong_occlusion/model.hpp"
#include "visibility/scene/generators.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numbers>
#include <string>
#include <vector>

using namespace visibility;
namespace model = strong_occlusion::model;
namespace plane = model::plane;

namespace {

constexpr double unit = 100;  // half the spacing: the paper's unit of length

struct Point {
  double x, y;
};

struct Circles {
  std::vector<Point> centres;  ///< nearest to the origin first
  double radius;
};

double norm(Point p) { return std::hypot(p.x, p.y); }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }

Circles circles(int n, double radius, int seed)
{
  Scene const scene = generate("circles,n=" + std::to_string(n) + ",radius=" + std::to_string(radius * unit) +
                               ",spacing=" + std::to_string(2 * unit) + ",seed=" + std::to_string(seed));
  Circles out{{}, radius};
  for (auto const& b : scene.balls) out.centres.push_back({b.centre.x / unit, b.centre.y / unit});
  std::ranges::sort(out.centres, {}, norm);
  return out;
}

/// Directions in which a disc is seen, relative to `axis`.
struct View {
  double middle, half, distance;
};

View view(Point from, Point centre, double radius, double axis = 0)
{
  Point const to = centre - from;
  double const d = norm(to);
  return {std::remainder(std::atan2(to.y, to.x) - axis, 2 * std::numbers::pi), std::asin(std::min(1.0, radius / d)), d};
}

/// Whether disc o hides the disc s of the same radius from each corner of the cell; then it does from all of the cell.
bool strong_occluder(std::vector<Point> const& corners, Point o, Point s, double radius)
{
  return std::ranges::all_of(corners, [&](Point p) {
    View const target = view(p, s, radius), own = view(p, o, radius);
    double const apart = std::abs(std::remainder(own.middle - target.middle, 2 * std::numbers::pi));
    return own.distance < target.distance && apart + target.half <= own.half;
  });
}

/// For each circle, whether it has a strong occluder.
std::vector<char> strongly_occluded(Circles const& scene, double cell)
{
  std::vector<Point> const corners{{cell, cell}, {-cell, cell}, {cell, -cell}, {-cell, -cell}};
  std::vector<char> hidden(scene.centres.size());
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    Point const s = scene.centres[i];
    for (std::size_t j = 0; j < i && hidden[i] == 0; ++j) {
      Point const o = scene.centres[j];  // a strong occluder meets the line from the middle of the cell
      double const along = o.x * s.x + o.y * s.y, across = o.x * s.y - o.y * s.x;
      if (along > 0 && std::abs(across) <= scene.radius * norm(s))
        hidden[i] = strong_occluder(corners, o, s, scene.radius);
    }
  }
  return hidden;
}

/// A union of intervals of directions, disjoint and apart.
class Shadows {
public:
  bool covers(double from, double to) const
  {
    auto const after = parts_.upper_bound(from);
    return after != parts_.begin() && std::prev(after)->second >= to;
  }
  void add(double from, double to)
  {
    auto it = parts_.upper_bound(from);
    if (it != parts_.begin() && std::prev(it)->second >= from) --it;
    while (it != parts_.end() && it->first <= to) {
      from = std::min(from, it->first), to = std::max(to, it->second);
      it = parts_.erase(it);
    }
    parts_.emplace(from, to);
  }

private:
  std::map<double, double> parts_;
};

/// Marks the circles that are seen from p. Circles of one radius that do not overlap hide each other in the order of
/// their distances: p and a farther one are on different sides of the line midway between two of them.
void mark_seen(Circles const& scene, Point p, std::vector<char>& seen)
{
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < scene.centres.size(); ++i) order.emplace_back(norm(scene.centres[i] - p), i);
  std::ranges::sort(order);
  Shadows shadows;
  for (auto const& [distance, i] : order) {
    View const v = view(p, scene.centres[i], scene.radius);
    double const turn = 2 * std::numbers::pi;
    if (!shadows.covers(v.middle - v.half, v.middle + v.half)) seen[i] = 1;
    for (double const shift : {-turn, 0.0, turn}) shadows.add(v.middle - v.half + shift, v.middle + v.half + shift);
  }
}

std::vector<char> seen_from_rim(Circles const& scene, double cell, int viewpoints)
{
  std::vector<char> seen(scene.centres.size());
  for (int i = 0; i < viewpoints; ++i) {
    double const t = 8.0 * i / viewpoints, s = std::fmod(t, 2.0) - 1;
    int const side = static_cast<int>(t / 2);
    Point const p = side == 0 ? Point{1, s} : side == 1 ? Point{-s, 1} : side == 2 ? Point{-1, -s} : Point{s, -1};
    mark_seen(scene, {cell * p.x, cell * p.y}, seen);
  }
  return seen;
}

struct Mean {
  double sum = 0, squares = 0, n = 0;
  void add(double x) { sum += x, squares += x * x, n += 1; }
  double value() const { return sum / n; }
  double error() const { return n < 2 ? 0 : std::sqrt(std::max(0.0, squares / n - value() * value()) / (n - 1)); }
};

struct Bin {
  Mean distance, potential, seen;                   // measured, one value for each scene
  Mean fixed_p2, poisson_p2, fixed_p1, poisson_p1;  // the model as it stands
  Mean corrected_p2, corrected_p1;                  // for what the cell looks like from the circle
};

/// Theorem 4 of proofs/strong_occlusion_model.md for one target: the shaft starts in the middle of the cell with the
/// half width that a square shows in this direction, and has centres only beyond the free square of half side 1.
struct Corrected {
  double potential, swept;
  Corrected(Point s, double radius, double cell)
  {
    double const D = norm(s), cosine = std::abs(s.x) / D, sine = std::abs(s.y) / D;
    double const width = cell * (cosine + sine), start = 1 / std::max(cosine, sine),
                 rest = (D - start) * (D - start) / D;
    double const single = plane::paper_density * (radius - width) * rest;
    double const ends = plane::paper_density * (width * rest + radius * (D - start * start / D));
    potential = std::exp(-std::max(single, 0.0));
    swept = std::exp(-single - ends) * (1 + ends);
  }
};

/// Rate of exponential decay of a column: minus the slope between the bins in which `measured` is first below 0.9 and
/// last above 8 standard errors.
double decay(std::vector<Bin> const& bins, Mean Bin::*measured, Mean Bin::*column)
{
  Bin const *first = nullptr, *last = nullptr;
  for (auto const& b : bins) {
    if (b.distance.n == 0) continue;
    double const p = (b.*measured).value();
    if (p >= 0.9 || p <= 8 * (b.*measured).error()) continue;
    first = first == nullptr ? &b : first;
    last = &b;
  }
  if (first == last) return std::nan("");
  return std::log((first->*column).value() / (last->*column).value()) /
         (last->distance.value() - first->distance.value());
}

void run(double radius, double cell, int scenes, int n, int viewpoints)
{
  double const m = model::size_ratio(radius, model::mean_half_width(radius, cell)), farthest = n - 2;
  double const width = std::min(farthest / 12, 1.5 / radius);
  std::vector<Bin> bins(12);
  for (int seed = 1; seed <= scenes; ++seed) {
    Circles const scene = circles(n, radius, seed);
    auto const hidden = strongly_occluded(scene, cell);
    auto const seen = seen_from_rim(scene, cell, viewpoints);
    std::vector<Bin> sums(bins.size());
    for (std::size_t i = 0; i < hidden.size(); ++i) {
      double const d = norm(scene.centres[i]) - cell, K = plane::potential_occluders(radius, cell, d);
      auto const bin = static_cast<std::size_t>(d / width);
      if (bin >= bins.size() || d > farthest - cell) continue;
      auto& s = sums[bin];
      s.distance.add(d), s.potential.add(hidden[i] == 0), s.seen.add(seen[i]);
      s.fixed_p2.add(plane::not_strongly_occluded(K, m)), s.fixed_p1.add(plane::expected_gaps(K, m));
      s.poisson_p2.add(plane::not_strongly_occluded_poisson(K, m)), s.poisson_p1.add(plane::uncovered_poisson(K, m));
      Corrected const corrected(scene.centres[i], radius, cell);
      s.corrected_p2.add(corrected.potential), s.corrected_p1.add(corrected.swept);
    }
    for (std::size_t k = 0; k < bins.size(); ++k) {
      if (sums[k].distance.n == 0) continue;
      for (auto what : {&Bin::distance, &Bin::potential, &Bin::seen, &Bin::fixed_p2, &Bin::poisson_p2, &Bin::fixed_p1,
                        &Bin::poisson_p1, &Bin::corrected_p2, &Bin::corrected_p1})
        (bins[k].*what).add((sums[k].*what).value());
    }
  }

  std::printf("\nR = %g, cell half side %g, m = %.3f; %d scenes\n", radius, cell, m, scenes);
  std::printf("%8s | %-18s %8s %8s %9s | %-18s %8s %8s %9s\n", "distance", "no strong occluder", "fixed K", "Poisson",
              "corrected", "seen", "fixed K", "Poisson", "corrected");
  for (auto const& b : bins)
    if (b.distance.n > 0)
      std::printf("%8.2f | %.4f +- %.4f   %8.4f %8.4f %9.4f | %.4f +- %.4f   %8.4f %8.4f %9.4f\n", b.distance.value(),
                  b.potential.value(), b.potential.error(), b.fixed_p2.value(), b.poisson_p2.value(),
                  b.corrected_p2.value(), b.seen.value(), b.seen.error(), b.fixed_p1.value(), b.poisson_p1.value(),
                  b.corrected_p1.value());
  std::printf("%8s | %.4f %20.4f %8.4f %9.4f | %.4f %20.4f %8.4f %9.4f\n", "decay",
              decay(bins, &Bin::potential, &Bin::potential), decay(bins, &Bin::potential, &Bin::fixed_p2),
              decay(bins, &Bin::potential, &Bin::poisson_p2), decay(bins, &Bin::potential, &Bin::corrected_p2),
              decay(bins, &Bin::seen, &Bin::seen), decay(bins, &Bin::seen, &Bin::fixed_p1),
              decay(bins, &Bin::seen, &Bin::poisson_p1), decay(bins, &Bin::seen, &Bin::corrected_p1));

  std::printf("{\"R\": %g, \"cell\": %g, \"scenes\": %d, \"n\": %d, \"viewpoints\": %d, \"bins\": [", radius, cell,
              scenes, n, viewpoints);
  char const* separator = "";
  for (auto const& b : bins)
    if (b.distance.n > 0) {
      std::printf(
        "%s{\"distance\": %.4f, \"potential\": [%.6f, %.6f], \"potential_fixed\": %.6f, "
        "\"potential_poisson\": %.6f, \"potential_corrected\": %.6f, \"seen\": [%.6f, %.6f], \"seen_fixed\": %.6f, "
        "\"seen_poisson\": %.6f, \"seen_corrected\": %.6f}",
        separator, b.distance.value(), b.potential.value(), b.potential.error(), b.fixed_p2.value(),
        b.poisson_p2.value(), b.corrected_p2.value(), b.seen.value(), b.seen.error(), b.fixed_p1.value(),
        b.poisson_p1.value(), b.corrected_p1.value());
      separator = ", ";
    }
  std::printf("]}\n");
}

}  // namespace

int main(int argc, char** argv)
{
  int const scenes = argc > 1 ? std::atoi(argv[1]) : 20;
  int const n = argc > 2 ? std::atoi(argv[2]) : 100;
  int const viewpoints = argc > 3 ? std::atoi(argv[3]) : 200;
  if (scenes < 1 || n < 4 || viewpoints < 1) {
    std::fprintf(stderr, "usage: strong_occlusion_model_bench [scenes >= 1] [n >= 4] [viewpoints >= 1]\n");
    return 2;
  }
  std::printf("Distances in units of half a grid cell. +-: one standard error over scenes.\n");
  for (double const radius : {0.5, 0.1})
    for (double const share : {0.001, 0.2, 0.5, 1.0}) run(radius, share * radius, scenes, n, viewpoints);
}
