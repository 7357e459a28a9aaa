#include "visibility/raster/convolution.hpp"

#include "pixel_oracle.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

DepthMap<float> random_map(Random& random)
{
  DepthMap<float> map(random.between(1, 40), random.between(1, 30));
  double const holes = random.chance(0.3) ? 0.3 : 0.01;
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      if (!random.chance(holes)) map.row(y)[x] = static_cast<float>(random.between(-50, 50));
  return map;
}

float eroded(DepthMap<float> const& map, PixelKernel const& kernel, int x, int y)
{
  float farthest = -HUGE_VALF;
  for (auto const& r : kernel.rows)
    for (int k = r.begin; k < r.end; ++k) {
      int const u = x + k, v = y + r.row;
      bool const within = u >= 0 && v >= 0 && u < map.width() && v < map.height();
      farthest = std::max(farthest, within ? map.at(u, v) : DepthMap<float>::empty);
    }
  return farthest;
}

bool same_everywhere(DepthMap<float> const& map, PixelKernel const& kernel)
{
  auto const result = erode(map, kernel);
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      if (result.at(x, y) != eroded(map, kernel, x, y)) return false;
  return true;
}

std::vector<Point2d> random_kernel(Random& random)
{
  std::vector<Point2d> points;
  double const size = random.uniform(0, 6), lattice = random.chance(0.5) ? 1 : 0.5;
  for (int n = random.between(1, 5); n > 0; --n) {
    points.push_back({random.uniform(-size, size), random.uniform(-size, size)});
    if (random.chance(lattice)) points.back() = {std::round(points.back().x), std::round(points.back().y)};
  }
  return points;
}

}  // namespace

TEST_CASE("erosion: by rectangles and polygons, is the maximum over the kernel's pixels", "[raster][law]")
{
  property("erode == brute force", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    auto const map = random_map(random);
    double const x = random.uniform(-9, 9), y = random.uniform(-9, 9);
    RC_ASSERT(
      same_everywhere(map, PixelKernel::rectangle({x, y}, {x + random.uniform(0, 20), y + random.uniform(0, 20)})));
    RC_ASSERT(same_everywhere(map, PixelKernel::polygon(Outline{random_kernel(random)})));
  });
}

TEST_CASE("erosion: kernels reach the pixels whose interior a pixel moved by them comes into", "[raster][oracle]")
{
  auto const grid = Grid::covering({0, 0}, {1, 1}, 1, 1);
  Random random(21);
  int exact = 0;
  for (int i = trials(150); i > 0; --i) {
    auto const points = random_kernel(random);
    auto const q = in_pixels(grid, points);
    auto const kernel = PixelKernel::polygon(Outline{points});
    auto const reaches = [&](int x, int y) {  // what the kernel says
      for (auto const& r : kernel.rows)
        if (r.row == y) return r.begin <= x && x < r.end;
      return false;
    };
    bool const on_lattice = std::all_of(
      points.begin(), points.end(), [](Point2d const& p) { return p.x == std::round(p.x) && p.y == std::round(p.y); });
    // The open square of two pixels, as a closed one a little smaller, or larger.
    auto const meets = [&](int x, int y, Q const& larger) {
      Q const y0 = Q(y - 1) - larger, y1 = Q(y + 1) + larger;
      auto const strip = in_strip(q, y0, y1, on_line(q, y0), on_line(q, y1));
      return strip && strip->low <= Q(x + 1) + larger && strip->high >= Q(x - 1) - larger;
    };
    Q const little = Q(1) / Q(1 << 30);
    for (int y = -9; y <= 9; ++y)
      for (int x = -9; x <= 9; ++x) {
        CAPTURE(x, y, i);
        if (meets(x, y, -little)) REQUIRE(reaches(x, y));
        if (reaches(x, y)) REQUIRE(meets(x, y, on_lattice ? -little : little));
        exact += on_lattice;
      }
  }
  REQUIRE(exact > 0);
}

TEST_CASE("erosion: a point at whole pixels shifts; a rectangle is its polygon", "[raster]")
{
  CHECK(PixelKernel::rectangle({2, -1}, {2, -1}).rows == Spans{{-1, 2, 3}});
  CHECK(PixelKernel::rectangle({0, 0}, {1, 0.5}).rows == Spans{{0, 0, 2}, {1, 0, 2}});
  CHECK(PixelKernel::rectangle({-0.25, 0}, {0, 0}).rows == Spans{{0, -1, 1}});
  Random random(22);
  for (int i = 0; i < 50; ++i) {
    Point2d const low{0.25 * random.between(-20, 20), 0.25 * random.between(-20, 20)},
      high{low.x + 0.25 * random.below(30), low.y + 0.25 * random.below(30)};
    std::vector<Point2d> const corners{low, {high.x, low.y}, high, {low.x, high.y}};
    CHECK(PixelKernel::rectangle(low, high).rows == PixelKernel::polygon(Outline{corners}).rows);
  }
  DepthMap<double> map(5, 4);
  map.row(2)[3] = 7;
  auto const shifted = erode(map, PixelKernel::rectangle({2, 1}, {2, 1}));
  CHECK(shifted.at(1, 1) == 7);
  CHECK(std::count_if(shifted.row(0), shifted.row(0) + 20, [](double d) { return d < HUGE_VAL; }) == 1);
  CHECK_THROWS_AS(PixelKernel::rectangle({0, 0}, {1e9, 0}), std::invalid_argument);
  CHECK_THROWS_AS(PixelKernel::polygon(Outline{}), std::invalid_argument);
  std::vector<Point2d> const far{{1e9, 0}};
  CHECK_THROWS_AS(PixelKernel::polygon(Outline{far}), std::invalid_argument);
  CHECK_THROWS_AS(erode(map, PixelKernel{}), std::invalid_argument);
}
