#include "visibility/raster/grid.hpp"

#include "pixel_oracle.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include <cmath>

using namespace visibility;
using namespace visibility::test;

TEST_CASE("grid: lines are exactly origin + i step, and enclose the rectangle tightly", "[raster][law]")
{
  Random random(11);
  for (int i = trials(300); i > 0; --i) {
    double const scale = std::ldexp(1.0, random.between(-600, 600));
    double const x = scale * random.uniform(-1, 1), y = scale * random.uniform(-1, 1);
    double const width = scale * std::ldexp(random.uniform(0.5, 1), -random.between(0, 30)), height = scale;
    Point2d const low{x, y}, high{x + width, y + height};
    if (!(low.x < high.x)) continue;
    auto const grid = Grid::covering(low, high, random.between(1, 4096), random.between(1, 4096));
    Q const step_x(grid.step().x), step_y(grid.step().y);
    auto const index = [&](int n) { return random.chance(0.3) ? n : random.between(0, n); };
    for (int k = 0; k < 8; ++k) {
      int const c = index(grid.width()), r = index(grid.height());
      REQUIRE(Q(grid.column_line(c)) == Q(grid.origin().x) + Q(c) * step_x);
      REQUIRE(Q(grid.row_line(r)) == Q(grid.origin().y) + Q(r) * step_y);
    }
    double const right = grid.column_line(grid.width()), top = grid.row_line(grid.height());
    REQUIRE((grid.origin().x <= low.x && high.x <= right && grid.origin().y <= low.y && high.y <= top));
    double const slack_x = 0x1p-37 * std::max(std::fabs(low.x), std::fabs(high.x)),
                 slack_y = 0x1p-37 * std::max(std::fabs(low.y), std::fabs(high.y));
    REQUIRE((low.x - grid.origin().x < slack_x && right - high.x < slack_x));
    REQUIRE((low.y - grid.origin().y < slack_y && top - high.y < slack_y));
  }
}

TEST_CASE("grid: short pixel sizes are kept", "[raster]")
{
  auto const grid = Grid::covering({-2, 10}, {14, 12.5}, 16, 10);
  CHECK(grid.origin() == Point2d{-2, 10});
  CHECK(grid.step() == Point2d{1, 0.25});
}

TEST_CASE("grid: bad rectangles and sizes are refused", "[raster]")
{
  CHECK_THROWS_AS(Grid::covering({0, 0}, {1, 1}, 0, 4), std::invalid_argument);
  CHECK_THROWS_AS(Grid::covering({0, 0}, {1, 1}, 4, 4097), std::invalid_argument);
  CHECK_THROWS_AS(Grid::covering({0, 0}, {0, 1}, 4, 4), std::invalid_argument);
  CHECK_THROWS_AS(Grid::covering({0, 1}, {1, 0}, 4, 4), std::invalid_argument);
  CHECK_THROWS_AS(Grid::covering({0, std::nan("")}, {1, 1}, 4, 4), std::invalid_argument);
  CHECK_THROWS_AS(Grid::covering({0, 0}, {HUGE_VAL, 1}, 4, 4), std::invalid_argument);
  CHECK_THROWS_AS(Grid::covering({0, 0}, {1e300, 1}, 4, 4), std::invalid_argument);
  CHECK_THROWS_AS(Grid::covering({0, 0}, {1e-300, 1}, 4, 4), std::invalid_argument);
  CHECK_THROWS_AS(Grid::covering({1, 0}, {std::nextafter(1, 2), 1}, 4, 4), std::invalid_argument);
}
