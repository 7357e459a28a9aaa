// Guided sampling in a city of boxes: rays per second, and recall against rays.
//
//   sampling_bench [n = 100] [reference rays = 3e7] [threads = 0]
//
// Input: n x n houses on a grid of 30 m, streets of about 10 m, heights 5 to 25 m and one tower of up to 120 m in 40,
// seed 1; street cell of 2 m x 2 m x 1 m at the middle crossing. Recall is counted against all that any run found, a
// lower bound of the truth. One JSON object per line.

#include "visibility/evidence/ray_scene.hpp"
#include "visibility/methods/sampling/method.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>

using namespace visibility;

namespace {

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Scene city(int n)
{
  std::mt19937_64 engine(1);
  auto const uniform = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  SceneBuilder b("sampling_bench");
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      double const x = 30 * i, y = 30 * j, inset = uniform(3, 7);
      double const top = uniform(0, 1) < 1.0 / 40 ? uniform(30, 120) : uniform(5, 25);
      b.begin_object(std::to_string(i) + "," + std::to_string(j));
      b.add(Box{{x + inset, y + inset, 0}, {x + 30 - inset, y + 30 - inset, top}});
    }
  return b.finish();
}

}  // namespace

int main(int argc, char** argv)
{
  int const n = argc > 1 ? std::atoi(argv[1]) : 100;
  auto const most = static_cast<std::uint64_t>(argc > 2 ? std::atof(argv[2]) : 3e7);
  int const threads = argc > 3 ? std::atoi(argv[3]) : 0;
  Scene const scene = city(n);
  auto start = std::chrono::steady_clock::now();
  PreparedScene const prepared(scene);
  double const prepare = seconds_since(start);
  start = std::chrono::steady_clock::now();
  RayScene const rays(prepared);
  std::printf("{\"objects\": %zu, \"prepare_s\": %.3f, \"ray_scene_s\": %.3f}\n", scene.objects.size(), prepare,
              seconds_since(start));
  double const c = 30 * (n / 2);
  ViewCell const cell(Box{{c - 1, c - 1, 1}, {c + 1, c + 1, 2}});

  struct Run {
    std::uint64_t rays, seed;
    double seconds;
    PotentiallyVisibleSet set;
  };
  std::vector<Run> runs;
  for (std::uint64_t r = 10'000; r <= most; r *= 10)
    for (std::uint64_t seed : {1U, 2U}) {
      start = std::chrono::steady_clock::now();
      auto set = Sampling({r, 0, seed, threads})(rays, cell);
      runs.push_back({r, seed, seconds_since(start), std::move(set)});
    }
  start = std::chrono::steady_clock::now();
  auto reference = Sampling({most, 0, 3, threads})(rays, cell);
  runs.push_back({most, 3, seconds_since(start), std::move(reference)});

  std::set<std::uint32_t> all;
  for (auto const& r : runs) all.insert(r.set.visible.begin(), r.set.visible.end());
  for (auto const& r : runs) {
    std::printf(
      "{\"rays\": %llu, \"seed\": %llu, \"found\": %zu, \"recall\": %.4f, \"seconds\": %.3f, \"rays_per_s\": %.0f",
      static_cast<unsigned long long>(r.rays), static_cast<unsigned long long>(r.seed), r.set.visible.size(),
      double(r.set.visible.size()) / double(all.size()), r.seconds, double(r.rays) / r.seconds);
    for (auto const& [name, value] : r.set.statistics)
      if (name.starts_with("finds_") || name.starts_with("rays_") || name == "rejected")
        std::printf(", \"%s\": %.0f", name.c_str(), value);
    std::printf("}\n");
  }
}
