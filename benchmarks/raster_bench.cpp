/// Rasters: scan conversion, depth maps, pyramids, erosion.
///
/// Families, seed 1, on a 1024 x 1024 raster unless the name says otherwise:
///   big      hexagons that fill most of the raster        small  quadrilaterals of about 10 x 10 pixels
///   tiny     quadrilaterals of about 2 x 2 pixels
///   views8   eight views of one hexagon, displaced by some pixels
/// `per_pixel` is the time of one pixel of the result, `per_item` of one polygon, query or map. Results are checked
/// before they are timed. JSON: --benchmark_format=json --benchmark_repetitions=5.
#include "harness.hpp"
#include "support/random.hpp"
#include "visibility/raster/contours.hpp"
#include "visibility/raster/convolution.hpp"
#include "visibility/raster/hierarchical_depth_map.hpp"

#include <cmath>
#include <numbers>

using namespace visibility;
using namespace visibility::bench;

namespace {

constexpr int size = 1024;
using Polygon = std::vector<Point2d>;

Grid const& grid()
{
  static Grid const g = Grid::covering({0, 0}, {size, size}, size, size);
  return g;
}

/// A polygon of n corners near a circle.
Polygon round_polygon(test::Random& random, Point2d const& centre, double radius, int n)
{
  Polygon p;
  double const turn = random.uniform(0, 1);
  for (int i = 0; i < n; ++i) {
    double const t = 2 * std::numbers::pi * (i + turn) / n;
    p.push_back({centre.x + radius * std::cos(t), centre.y + radius * std::sin(t)});
  }
  return p;
}

std::vector<Polygon> polygons(double radius, int corners, int count)
{
  test::Random random(1);
  std::vector<Polygon> result;
  for (int i = 0; i < count; ++i)
    result.push_back(round_polygon(
      random, {random.uniform(radius, size - radius), random.uniform(radius, size - radius)}, radius, corners));
  return result;
}

/// Eight views of each polygon, a few pixels apart.
std::vector<Polygon> views(Polygon const& p, double shift)
{
  std::vector<Polygon> result;
  for (int v = 0; v < 8; ++v) {
    Polygon q = p;
    for (auto& c : q) c = {c.x + ((v & 1) != 0 ? shift : 0), c.y + ((v & 2) != 0 ? shift : 0) + (v & 4) / 8.0};
    result.push_back(q);
  }
  return result;
}

PixelDepth slanted(double value) { return PixelDepth::above(grid(), {{0, 0}, value, {0.01, 0.02}}); }

std::vector<PixelDepth> eight_depths()
{
  std::vector<PixelDepth> depths;
  for (int v = 0; v < 8; ++v)
    depths.push_back(PixelDepth::above(grid(), {{0, 0}, 10.0 + v, {0.01 * v, 0.02 - 0.003 * v}}));
  return depths;
}

void count(benchmark::State& state, std::int64_t items, std::int64_t pixels)
{
  auto const per = [](std::int64_t n) {
    return benchmark::Counter(static_cast<double>(n),
                              benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  };
  state.counters["per_item"] = per(items);
  state.counters["per_pixel"] = per(pixels);
  state.counters["pixels"] = static_cast<double>(pixels) / static_cast<double>(items);
}

template <class F>
void add(std::string const& name, F const& f)
{
  benchmark::RegisterBenchmark(name.c_str(), f);
}

void check(bool correct, char const* what)
{
  if (correct) return;
  std::fprintf(stderr, "%s: wrong result\n", what);
  std::exit(1);
}

/// Scan conversion alone, and with depths written.
void add_family(std::string const& family, double radius, int corners, int n)
{
  auto const input = polygons(radius, corners, n);
  for (auto const cover : {Cover::inside, Cover::touching})
    add(std::string(cover == Cover::inside ? "inner/" : "outer/") + family, [=](benchmark::State& state) {
      PixelRegion region(grid());
      Spans spans;
      std::int64_t pixels = 0;
      for (auto _ : state) {
        pixels = 0;
        for (auto const& p : input) {
          region.reset();
          region.keep(Outline{p}, cover);
          region.spans(spans);
          pixels += pixel_count(spans);
        }
      }
      count(state, n, pixels);
    });
  add("inner_views8/" + family, [=](benchmark::State& state) {
    std::vector<std::vector<Polygon>> all;
    for (auto const& p : input) all.push_back(views(p, std::min(4.0, radius / 8)));
    PixelRegion region(grid());
    Spans spans;
    std::int64_t pixels = 0;
    for (auto _ : state) {
      pixels = 0;
      for (auto const& v : all) {
        region.reset();
        for (auto const& p : v) region.keep(Outline{p}, Cover::inside);
        region.spans(spans);
        pixels += pixel_count(spans);
      }
    }
    count(state, n, pixels);
  });
  add("inner_write/" + family, [=](benchmark::State& state) {
    PixelRegion region(grid());
    Spans spans;
    DepthMap<float> map(size, size);
    std::int64_t pixels = 0;
    for (auto _ : state) {
      pixels = 0;
      for (auto const& p : input) {
        region.reset();
        region.keep(Outline{p}, Cover::inside);
        region.spans(spans);
        map.write(spans, slanted(5));
        pixels += pixel_count(spans);
      }
    }
    count(state, n, pixels);
  });
}

Spans spans_of_disc(double radius)
{
  test::Random random(1);
  auto const p = round_polygon(random, {size / 2.0, size / 2.0}, radius, 64);
  return outer(grid(), Outline{p});
}

template <class T>
void add_writes(std::string const& type)
{
  auto const spans = spans_of_disc(500);
  auto const timed = [=](auto const& write) {
    return [=](benchmark::State& state) {
      DepthMap<T> map(size, size);
      for (auto _ : state) write(map);
      count(state, 1, pixel_count(spans));
    };
  };
  add("write/constant/" + type, timed([=](DepthMap<T>& map) {
        map.write(spans, PixelDepth::above(grid(), {{0, 0}, 5, {0, 0}}));
      }));
  add("write/affine/" + type, timed([=](DepthMap<T>& map) { map.write(spans, slanted(5)); }));
  add("write/views8/" + type, timed([=, d = eight_depths()](DepthMap<T>& map) { map.write(spans, d); }));
}

void add_pyramid()
{
  add("pyramid/build", [](benchmark::State& state) {
    HierarchicalDepthMap<float> map(size, size);
    auto const spans = spans_of_disc(720);
    for (auto _ : state) {
      state.PauseTiming();
      map.write(spans, slanted(9));
      state.ResumeTiming();
      map.refresh();
    }
    count(state, 1, size * size);
  });
  add("pyramid/refresh_after_small", [](benchmark::State& state) {
    HierarchicalDepthMap<float> map(size, size);
    Spans const spans{{500, 500, 510}, {501, 500, 510}};
    for (auto _ : state) {
      map.write(spans, slanted(9));
      map.refresh();
    }
    count(state, 1, 20);
  });
  HierarchicalDepthMap<float> map(size, size);
  map.write(spans_of_disc(400), slanted(5));
  map.refresh();
  for (auto const& [family, radius] : {std::pair("small", 5.0), std::pair("big", 100.0)}) {
    test::Random random(2);
    std::vector<Spans> sets;
    std::vector<PixelRectangle> boxes;
    int hidden = 0;
    for (int i = 0; i < 512; ++i) {
      auto const p = round_polygon(
        random, {random.uniform(radius, size - radius), random.uniform(radius, size - radius)}, radius, 6);
      sets.push_back(outer(grid(), Outline{p}));
      auto const& s = sets.back();
      boxes.push_back(
        {static_cast<int>(p[0].x - radius) - 1, s.front().row, static_cast<int>(p[0].x) + 1, s.back().row + 1});
      boxes.back().x0 = std::max(boxes.back().x0, 0);
      hidden += map.hidden(s, 100.0F);
    }
    check(hidden > 50 && hidden < 500, "pyramid/query");
    add(std::string("pyramid/query_polygon/") + family, [=](benchmark::State& state) {
      for (auto _ : state)
        for (auto const& s : sets) benchmark::DoNotOptimize(map.hidden(s, 100.0F));
      state.counters["hidden"] = hidden;
      count(state, 512, 512);
    });
    add(std::string("pyramid/query_rectangle/") + family, [=](benchmark::State& state) {
      for (auto _ : state)
        for (auto const& b : boxes) benchmark::DoNotOptimize(map.hidden(b, 100.0F));
      count(state, 512, 512);
    });
  }
}

void add_erosion()
{
  for (int const width : {4, 16, 64}) {
    double const w = width;
    std::vector<Point2d> const hexagon{{w / 4, 0}, {w, 0}, {w, w / 2}, {3 * w / 4, w}, {0, w}, {0, w / 2}};
    for (auto const& [name, kernel] : {std::pair("rectangle", PixelKernel::rectangle({0, 0}, {w, w})),
                                       std::pair("hexagon", PixelKernel::polygon(Outline{hexagon}))})
      add(std::string("erode/") + name + "/" + std::to_string(width), [kernel = kernel](benchmark::State& state) {
        DepthMap<float> map(size, size);
        map.write(spans_of_disc(500), slanted(5));
        for (auto _ : state) benchmark::DoNotOptimize(erode(map, kernel));
        count(state, 1, size * size);
      });
  }
}

void add_contours()
{
  test::Random random(3);
  Contours contours{round_polygon(random, {512, 512}, 500, 200), round_polygon(random, {512, 512}, 300, 100)};
  for (auto& p : contours[0]) p = {p.x + random.uniform(-9, 9), p.y + random.uniform(-9, 9)};
  auto const pixels = pixel_count(inner_even_odd(grid(), contours));
  check(pixels > 400000 && pixels < 520000, "contours");
  add("contours/300 edges", [=](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(inner_even_odd(grid(), contours));
    count(state, 1, pixels);
  });
}

}  // namespace

int main(int argc, char** argv)
{
  add_family("big", 400, 6, 16);
  add_family("small", 6, 4, 512);
  add_family("tiny", 1.5, 4, 512);
  add_writes<float>("float");
  add_writes<double>("double");
  add_pyramid();
  add_erosion();
  add_contours();
  return run(argc, argv);
}
