#include "visibility/raster/depth_map.hpp"

#include "pixel_oracle.hpp"
#include "polygons.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

Q depth_at(AffineDepth const& z, Grid const& grid, int column, int row)
{
  return Q(z.value) + Q(z.slope.x) * (Q(grid.column_line(column)) - Q(z.at.x)) +
         Q(z.slope.y) * (Q(grid.row_line(row)) - Q(z.at.y));
}

/// Least and greatest depth of a closed pixel: at its corners.
Interval depths_of_pixel(AffineDepth const& z, Grid const& grid, int x, int y)
{
  MaybeInterval result;
  for (int corner = 0; corner < 4; ++corner) extend(result, depth_at(z, grid, x + (corner & 1), y + corner / 2));
  return {result->low - Q(z.error), result->high + Q(z.error)};
}

AffineDepth random_depth(Grid const& grid, Random& random)
{
  AffineDepth z;
  double const scale = std::ldexp(1.0, random.between(-40, 40));
  z.at = {random.chance(0.3) ? 0 : random.uniform(-2, 2) * grid.column_line(grid.width()),
          random.chance(0.3) ? 0 : random.uniform(-2, 2) * grid.row_line(grid.height())};
  z.value = scale * (random.chance(0.5) ? random.between(-9, 9) : random.uniform(-9, 9));
  auto const slope = [&](double step) {
    return random.chance(0.2) ? 0 : scale / step * std::ldexp(random.uniform(-1, 1), -random.between(0, 30));
  };
  z.slope = {slope(grid.step().x), slope(grid.step().y)};
  if (random.chance(0.3)) z.error = scale * std::ldexp(1.0, -random.between(0, 50));
  return z;
}

Spans everywhere(Grid const& grid)
{
  Spans spans;
  for (int y = 0; y < grid.height(); ++y) spans.push_back({y, 0, grid.width()});
  return spans;
}

template <class T>
void check_map(int count, double tolerance)
{
  auto const grids = tested_grids();
  for (std::size_t g = 0; g < grids.size(); ++g) {
    auto const& grid = grids[g];
    Random random(40 + g);
    for (int i = trials(count); i > 0; --i) {
      std::vector<AffineDepth> views;
      for (int k = random.between(1, 8); k > 0; --k) views.push_back(random_depth(grid, random));
      if (random.chance(0.3)) views.push_back(views.front());
      std::vector<PixelDepth> bounds;
      double magnitude = 0;
      for (auto const& z : views) {
        bounds.push_back(PixelDepth::above(grid, z));
        magnitude = std::max(magnitude, bounds.back().magnitude());
      }
      DepthMap<T> map(grid.width(), grid.height());
      map.write(everywhere(grid), bounds);
      CAPTURE(g, i);
      for (int k = 0; k < 40; ++k) {
        int const x = random.below(grid.width()), y = random.below(grid.height());
        Q truth = depths_of_pixel(views.front(), grid, x, y).high;
        for (auto const& z : views) truth = std::max(truth, depths_of_pixel(z, grid, x, y).high);
        REQUIRE(Q(static_cast<double>(map.at(x, y))) >= truth);
        REQUIRE(Q(static_cast<double>(map.at(x, y))) <= truth + Q(tolerance * magnitude + 0x1p-140));
        auto const below = PixelDepth::below(grid, views.front());
        Q const nearest = depths_of_pixel(views.front(), grid, x, y).low;
        REQUIRE(Q(below(x, y)) <= nearest);
        REQUIRE(Q(below(x, y)) >= nearest - Q(0x1p-46 * below.magnitude() + 0x1p-140));
      }
    }
  }
}

}  // namespace

TEST_CASE("depth map: stores the farthest depth of a pixel, over all views, rounded away",
          "[raster][oracle][conservative]")
{
  check_map<float>(12, 0x1p-22);
  check_map<double>(12, 0x1p-46);
}

TEST_CASE("depth map: long rows of several views hold their upper envelope", "[raster][oracle]")
{
  auto const grid = Grid::covering({0.1, 0.2}, {700.3, 3.3}, 701, 2);
  Random random(3);
  for (int i = trials(40); i > 0; --i) {
    std::vector<PixelDepth> bounds;
    for (int k = 0; k < 8; ++k) {
      double const x = random.uniform(0, 700), slope = random.uniform(-2, 2);
      bounds.push_back(PixelDepth::above(grid, {{x, 0}, slope * slope, {slope, random.uniform(-1, 1)}}));
    }
    DepthMap<float> map(701, 2);
    map.write(everywhere(grid), bounds);
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 701; ++x) {
        double farthest = -HUGE_VAL;
        for (auto const& b : bounds) farthest = std::max(farthest, b(x, y));
        REQUIRE(map.at(x, y) >= farthest - 1e-9);
        REQUIRE(map.at(x, y) <= farthest + 1e-3);
      }
  }
}

TEST_CASE("depth map: constant depths and small numbers are kept exactly or rounded up", "[raster]")
{
  auto const grid = Grid::covering({0, 0}, {4, 4}, 4, 4);
  DepthMap<float> map(4, 4);
  map.write({{1, 0, 3}}, PixelDepth::above(grid, {{0, 0}, 0.1, {0, 0}}));
  CHECK(map.at(0, 1) > 0.1);
  CHECK(map.at(0, 1) == round_up<float>(0.1));
  map.write({{1, 0, 1}}, PixelDepth::above(grid, {{0, 0}, -2, {0, 0}}));
  CHECK(map.at(0, 1) == -2);
  map.write({{1, 0, 2}}, PixelDepth::above(grid, {{0, 0}, 7, {0, 0}}));
  CHECK(map.at(0, 1) == -2);  // the nearer one stays
  CHECK(map.at(3, 1) == DepthMap<float>::empty);
  map.write({{0, 0, 4}}, PixelDepth::above(grid, {{0, 0}, 1e200, {1, 0}}));
  CHECK(map.at(0, 0) == DepthMap<float>::empty);  // out of the domain hides nothing
  CHECK(PixelDepth::below(grid, {{0, 0}, -1e200, {1, 0}})(0, 0) == -HUGE_VAL);
  map.write({{0, 0, 4}}, PixelDepth::above(grid, {{0, 0}, std::nan(""), {1, 0}}));
  CHECK(map.at(0, 0) == DepthMap<float>::empty);
  map.write({{0, 0, 4}}, PixelDepth::above(grid, {{0, 0}, 0, {0x1p-149, 0}}));
  CHECK(map.at(3, 0) >= 4 * 0x1p-149);
  map.clear();
  CHECK(map == DepthMap<float>(4, 4));
  CHECK(nearest(PixelDepth::below(grid, {{0, 0}, 1, {-1, 0}}), {{0, 0, 2}, {1, 1, 4}}) <= -3);
  CHECK_THROWS_AS(DepthMap<float>(0, 4), std::invalid_argument);
}
