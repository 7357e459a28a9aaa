#include "drawing/pixel_path.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::detail::drawing;
using test::Random;

namespace {

/// Twice the signed area in pixels; negative for what is counterclockwise on the screen, where y points down.
double area(Path::Line const& line)
{
  double sum = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    auto const &a = line.points[i], &b = line.points[(i + 1) % line.points.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum;
}

PlanOutline square(Point2d const& at, double side)
{
  return {{{at, {at.x + side, at.y}, {at.x + side, at.y + side}, {at.x, at.y + side}}}, {}};
}

constexpr PlanRegion region{{0, 0}, {100, 50}};
constexpr Rectangle frame{10, 20, 400, 200};

}  // namespace

TEST_CASE("pixel path: one scale, y up becomes y down", "[drawing]")
{
  PixelMap const map(region, frame);
  REQUIRE(map.scale() == 4);
  REQUIRE(map({0, 0}) == Point2d{10, 220});
  REQUIRE(map({100, 50}) == Point2d{410, 20});
}

TEST_CASE("pixel path: whatever the size, all parts of a crowd turn the same way and stay near the frame",
          "[drawing][law]")
{
  PixelMap const map(region, frame);
  Crowd crowd(map, {0.3, 1});
  Random random(1);
  int large = 0, small = 0, tiny = 0;
  for (int i = 0; i < 3000; ++i) {
    double const side = std::pow(10, random.uniform(-3, 4));
    ++(side * map.scale() < 1 ? tiny : side * map.scale() < 4 ? small : large);
    crowd.add(square({random.uniform(-20, 120), random.uniform(-20, 70)}, side));
    if (i % 10 == 0) crowd.add({{}, {{{random.uniform(-20, 120), random.uniform(-20, 70)}, side}}});
  }
  REQUIRE((large > 100 && small > 100 && tiny > 100));
  auto const paths = crowd.paths();
  std::vector<Path::Line> lines;
  for (auto const& path : paths) lines.insert(lines.end(), path.lines.begin(), path.lines.end());
  REQUIRE(lines.size() > 200);
  REQUIRE(paths.size() > 1);
  for (auto const& line : lines) {
    CAPTURE(line.points.size());
    REQUIRE(area(line) <= 0);
    for (auto const& p : line.points) REQUIRE((p.x >= -33 && p.x <= 453 && p.y >= -23 && p.y <= 263));
  }
}

TEST_CASE("pixel path: what is smaller than a pixel is drawn once per pixel", "[drawing]")
{
  PixelMap const map(region, frame);
  Crowd crowd(map, {0.3, 1});
  for (int i = 0; i < 100; ++i) crowd.add(square({10 + 0.01 * (i % 10), 10}, 0.001));
  crowd.add(square({10.3, 10}, 0.001));  // the next pixel of the row
  auto const paths = crowd.paths();
  REQUIRE(paths.size() == 1);
  REQUIRE(paths[0].lines.size() == 1);
  REQUIRE(area(paths[0].lines[0]) == -2 * 2);
}

TEST_CASE("pixel path: lines are cut to the neighbourhood of the frame, and keep their direction", "[drawing]")
{
  PixelMap const map(region, frame);
  Path const across = pixel_path(PlanPicture::Segment{{-1e9, 25}, {1e9, 25}}, map);
  REQUIRE(across.lines.size() == 1);
  REQUIRE(!across.lines[0].closed);
  for (auto const& p : across.lines[0].points) REQUIRE(p.y == Approx(120));
  auto const [left, right] = std::ranges::minmax(across.lines[0].points, {}, &Point2d::x);
  REQUIRE((left.x < 10 && left.x > -100 && right.x > 410 && right.x < 500));
  REQUIRE(pixel_path(PlanPicture::Segment{{-1e9, 1e6}, {1e9, 1e6}}, map).empty());
}
