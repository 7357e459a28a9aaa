#include "visibility/raster/half_plane.hpp"

#include "pixel_oracle.hpp"
#include "polygons.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"
#include "visibility/raster/pixel_region.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

/// The least and greatest value of the half-plane over the pixel, enlarged by `margin` pixels.
Interval values(HalfPlane const& h, Grid const& grid, int x, int y, Q const& margin)
{
  MaybeInterval result;
  for (int corner = 0; corner < 4; ++corner) {
    Q const u = (corner & 1) != 0 ? Q(x + 1) + margin : Q(x) - margin,
            v = (corner & 2) != 0 ? Q(y + 1) + margin : Q(y) - margin;
    extend(result, Q(h.a) * (Q(grid.origin().x) + u * Q(grid.step().x)) +
                     Q(h.b) * (Q(grid.origin().y) + v * Q(grid.step().y)) + Q(h.c));
  }
  return *result;
}

HalfPlane random_half_plane(PolygonSource& source, bool exact)
{
  auto& random = source.random();
  auto const points = source(exact ? Shape::quarter : Shape::uniform);
  double a = exact ? random.between(-4, 4) : random.uniform(-1, 1),
         b = exact ? random.between(-4, 4) : random.uniform(-1, 1);
  if (random.chance(0.1)) a = 0;
  if (random.chance(0.1)) b = 0;
  double const scale = std::ldexp(1.0, random.between(-300, 300));
  return {a * scale, b * scale, -(a * points[0].x + b * points[0].y) * scale};
}

}  // namespace

TEST_CASE("raster: half-planes hold the pixels that are inside, or touched, within their side", "[raster][oracle]")
{
  auto const grids = tested_grids();
  Q const zero(0), margin = Q(1) / Q(1 << 30);
  long inside = 0, touched_only = 0, outside = 0;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    auto const& grid = grids[g];
    PolygonSource source(grid, 500 + g);
    for (int i = trials(25); i > 0; --i) {
      bool const exact = g < short_grids && source.random().chance(0.5);
      auto const h = random_half_plane(source, exact);
      auto const in = pixels_of(grid, h, Cover::inside), touch = pixels_of(grid, h, Cover::touching);
      for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) {
          auto const v = values(h, grid, x, y, zero);
          bool const is_in = in.a * x + in.b * y + in.c >= 0, is_touched = touch.a * x + touch.b * y + touch.c >= 0;
          if (is_in) REQUIRE(v.low >= zero);
          if (v.high >= zero) REQUIRE(is_touched);
          if (v.low >= zero && !is_in) {
            REQUIRE(!exact);
            REQUIRE(values(h, grid, x, y, margin).low < zero);
          }
          if (is_touched && v.high < zero) {
            REQUIRE(!exact);
            REQUIRE(values(h, grid, x, y, margin).high >= zero);
          }
          ++(is_in ? inside : is_touched ? touched_only : outside);
        }
    }
  }
  REQUIRE((inside > 1000 && touched_only > 500 && outside > 1000));
}

TEST_CASE("raster: the error of a half-plane counts on the safe side", "[raster][conservative]")
{
  auto const grid = Grid::covering({0, 0}, {8, 8}, 8, 8);
  PixelRegion in(grid), touch(grid);
  in.keep(HalfPlane{1, 0, -2, 0.5}, Cover::inside);  // x >= 2, give or take a half
  touch.keep(HalfPlane{1, 0, -2, 0.5}, Cover::touching);
  CHECK(in.bounds() == PixelRectangle{3, 0, 8, 8});
  CHECK(touch.bounds() == PixelRectangle{1, 0, 8, 8});
  Spans spans;
  for (auto const& h : {HalfPlane{0, 0, 1}, HalfPlane{0, 0, 1, 0.5}, HalfPlane{0, 0, 0}}) {
    PixelRegion r(grid);
    r.keep(h, Cover::inside);
    r.spans(spans);
    CHECK(pixel_count(spans) == 64);
  }
  for (auto const& h : {HalfPlane{0, 0, 1, 2}, HalfPlane{0, 0, -1}, HalfPlane{HUGE_VAL, 0, 0},
                        HalfPlane{1, 1, std::nan("")}, HalfPlane{1e308, 1, 0, HUGE_VAL}}) {
    PixelRegion r(grid);
    r.keep(h, Cover::inside);
    r.spans(spans);
    CHECK(spans.empty());
  }
}
