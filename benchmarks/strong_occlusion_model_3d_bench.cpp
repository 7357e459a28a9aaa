// The share of balls without strong occluder in space, against the analytic model (docs/strong-occlusion-model.md).
//
//   strong_occlusion_model_3d_bench [scenes = 20] [balls along each side = 30]
//
// Input: `generate("spheres,...")`, jittered grids of balls of radius 50 and 20, spacing 200 (R = 1/2 and 1/5 in units
// of half a grid cell), seeds 1, 2, ...; cubic cells in the middle of the free grid cell. Measured for true balls from
// the eight corners of the cell, exact but for rounding; +- is the standard error over scenes. Model: P2-hat with K
// fixed and b = (R + cell)/2, as printed; its Poisson average; Theorem 4 of proofs/strong_occlusion_model.md, which
// needs no b; and "corrected", Theorem 4 for the outline of the cube and without centres in the free grid cell. Table,
// then JSON.

#include "visibility/methods/strong_occlusion/model.hpp"
#include "visibility/scene/generators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

using namespace visibility;
namespace model = strong_occlusion::model;
namespace space = model::space;

namespace {

constexpr double unit = 100;  // half the spacing: the paper's unit of length
using Vector = std::array<double, 3>;

Vector operator-(Vector const& a, Vector const& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(Vector const& a, Vector const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(Vector const& a) { return std::sqrt(dot(a, a)); }
Vector cross(Vector const& a, Vector const& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Centres relative to the middle of the free grid cell, nearest first.
std::vector<Vector> balls(int n, double radius, int seed)
{
  Scene const scene = generate("spheres,n=" + std::to_string(n) + ",radius=" + std::to_string(radius * unit) +
                               ",spacing=" + std::to_string(2 * unit) + ",seed=" + std::to_string(seed));
  int const middle = n / 2;
  std::vector<Vector> out;
  for (auto const& b : scene.balls)
    out.push_back({b.centre.x / unit, b.centre.y / unit, b.centre.z / unit - (2 * middle + 1)});
  std::ranges::sort(out, {}, norm);
  return out;
}

std::array<Vector, 8> corners(double cell)
{
  std::array<Vector, 8> out;
  for (unsigned i = 0; i < 8; ++i)
    out[i] = {(i & 1U) != 0 ? cell : -cell, (i & 2U) != 0 ? cell : -cell, (i & 4U) != 0 ? cell : -cell};
  return out;
}

/// Whether ball o hides ball s of the same radius from p: the cone of s lies in that of o, and o is nearer.
bool hides(Vector const& p, Vector const& o, Vector const& s, double radius)
{
  Vector const to = o - p, target = s - p;
  double const near = norm(to), far = norm(target);
  double const apart = std::atan2(norm(cross(to, target)), dot(to, target));
  return near < far && apart + std::asin(radius / far) <= std::asin(std::min(1.0, radius / near));
}

bool has_strong_occluder(std::vector<Vector> const& scene, std::size_t target, double radius,
                         std::array<Vector, 8> const& cell)
{
  Vector const& s = scene[target];
  double const reach = radius * norm(s);
  for (std::size_t j = 0; j < target; ++j) {
    Vector const& o = scene[j];  // a strong occluder meets the line from the middle of the cell
    if (dot(o, s) <= 0 || norm(cross(o, s)) > reach) continue;
    if (std::ranges::all_of(cell, [&](Vector const& p) { return hides(p, o, s, radius); })) return true;
  }
  return false;
}

/// Expected strong occluders of Theorem 4 when the cell is a cube seen along s. At depth x of D a great disc must hold
/// (1 - x/D) v + (x/D) B_R for each corner v of the outline: centres in (1 - x/D) times what discs of radius R about
/// the outline's corners have in common. No centres before the free grid cell ends.
double corrected(Vector const& s, double radius, std::array<Vector, 8> const& cell)
{
  double const D = norm(s), start = D / std::max({std::abs(s[0]), std::abs(s[1]), std::abs(s[2])});
  Vector const axis{s[0] / D, s[1] / D, s[2] / D};
  Vector u = cross(axis, std::abs(axis[0]) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0});
  for (double const length = norm(u); auto& x : u) x /= length;
  Vector const v = cross(axis, u);
  constexpr int grid = 40;
  int common = 0;
  for (int i = 0; i < grid; ++i)
    for (int j = 0; j < grid; ++j) {
      double const x = radius * ((2 * i + 1.0) / grid - 1), y = radius * ((2 * j + 1.0) / grid - 1);
      common +=
        std::ranges::all_of(cell, [&](Vector const& p) { return std::hypot(x - dot(p, u), y - dot(p, v)) <= radius; });
    }
  double const area = 4 * radius * radius * common / (grid * grid);
  return space::paper_density * area * std::pow(D - start, 3) / (3 * D * D);
}

struct Mean {
  double sum = 0, squares = 0, n = 0;
  void add(double x) { sum += x, squares += x * x, n += 1; }
  double value() const { return sum / n; }
  double error() const { return n < 2 ? 0 : std::sqrt(std::max(0.0, squares / n - value() * value()) / (n - 1)); }
};

struct Bin {
  Mean distance, measured, fixed, poisson, theorem, corrected;
};

void run(double radius, double half_side, int scenes, int n)
{
  double const m = model::size_ratio(radius, model::mean_half_width(radius, half_side)), farthest = n - 2;
  auto const cell = corners(half_side);
  constexpr std::size_t count = 8;
  std::vector<Bin> bins(count);
  for (int seed = 1; seed <= scenes; ++seed) {
    auto const scene = balls(n, radius, seed);
    std::vector<Bin> sums(count);
    for (std::size_t i = 0; i < scene.size(); i += 7) {  // every seventh ball is a target, all are occluders
      double const D = norm(scene[i]), d = D - half_side, K = space::potential_occluders(radius, half_side, d);
      auto const bin = static_cast<std::size_t>(D / farthest * count);
      if (bin >= count) break;
      auto& s = sums[bin];
      s.distance.add(d), s.measured.add(!has_strong_occluder(scene, i, radius, cell));
      s.fixed.add(space::not_strongly_occluded(K, m)), s.poisson.add(space::not_strongly_occluded_poisson(K, m));
      s.theorem.add(std::exp(-space::strong_occluders(radius, half_side, d)));
      s.corrected.add(std::exp(-corrected(scene[i], radius, cell)));
    }
    for (std::size_t k = 0; k < count; ++k)
      for (auto what : {&Bin::distance, &Bin::measured, &Bin::fixed, &Bin::poisson, &Bin::theorem, &Bin::corrected})
        if (sums[k].distance.n > 0) (bins[k].*what).add((sums[k].*what).value());
  }
  std::printf("\nR = %g, cell half side %g, m = %.3f; %d scenes\n", radius, half_side, m, scenes);
  std::printf("%8s | %-18s %8s %8s %9s %9s\n", "distance", "no strong occluder", "fixed K", "Poisson", "Theorem 4",
              "corrected");
  std::string json;
  for (auto const& b : bins) {
    if (b.distance.n == 0) continue;
    std::printf("%8.2f | %.4f +- %.4f   %8.4f %8.4f %9.4f %9.4f\n", b.distance.value(), b.measured.value(),
                b.measured.error(), b.fixed.value(), b.poisson.value(), b.theorem.value(), b.corrected.value());
    std::array<char, 256> text;
    std::snprintf(text.data(), text.size(),
                  "%s{\"distance\": %.4f, \"potential\": [%.6f, %.6f], \"fixed\": %.6f, \"poisson\": %.6f, "
                  "\"theorem\": %.6f, \"corrected\": %.6f}",
                  json.empty() ? "" : ", ", b.distance.value(), b.measured.value(), b.measured.error(), b.fixed.value(),
                  b.poisson.value(), b.theorem.value(), b.corrected.value());
    json += text.data();
  }
  std::printf("{\"R\": %g, \"cell\": %g, \"scenes\": %d, \"n\": %d, \"bins\": [%s]}\n", radius, half_side, scenes, n,
              json.c_str());
}

}  // namespace

int main(int argc, char** argv)
{
  int const scenes = argc > 1 ? std::atoi(argv[1]) : 20, n = argc > 2 ? std::atoi(argv[2]) : 30;
  if (scenes < 1 || n < 4 || n % 2 != 0) {
    std::fprintf(stderr, "usage: strong_occlusion_model_3d_bench [scenes >= 1] [even n >= 4]\n");
    return 2;
  }
  std::printf("Distances in units of half a grid cell. +-: one standard error over scenes.\n");
  for (double const radius : {0.5, 0.2})
    for (double const share : {0.001, 0.1, 0.3}) run(radius, share * radius, scenes, n);
}
