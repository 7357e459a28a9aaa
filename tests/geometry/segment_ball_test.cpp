#include "segment_checks.hpp"
#include "visibility/geometry/segment_ball.hpp"

using namespace visibility;
using namespace visibility::test;

TEST_CASE("segment_ball: agrees with the quadratic, closed and half-open, at all scales",
          "[geometry][oracle][degenerate]")
{
  Random random(65);
  Reached reached;
  for (double const scale : scales)
    for (int i = 0; i < trials(150); ++i) {
      Point3d const c = even_point(random, 4);
      int const k = random.between(0, 2);
      Ball const ball{scaled(c, scale), 14.0 * k * scale};
      // Landmarks: points of the sphere (2, 3, 6 and 7), the poles, the centre.
      std::vector<Point3d> v{ball.centre,
                             {ball.centre.x + ball.radius, ball.centre.y, ball.centre.z},
                             {ball.centre.x, ball.centre.y - ball.radius, ball.centre.z}};
      for (int j = 0; j < 4; ++j) {
        double const sx = random.chance(0.5) ? 1 : -1, sy = random.chance(0.5) ? 1 : -1;
        v.push_back(scaled({c.x + sx * 4 * k, c.y + sy * 6 * k, c.z + 12 * k}, scale));
        // Beyond such a point along a tangent.
        double const m = 2 * random.between(-3, 3);
        v.push_back(scaled({c.x + sx * (4 * k + 3 * m), c.y + sy * (6 * k - 2 * m), c.z + 12 * k}, scale));
      }
      CAPTURE(i, ball.centre.x, ball.centre.y, ball.centre.z, ball.radius);
      check_segments(ball, v, random, scale, 15, reached);
    }
  require_reached(reached);
}

TEST_CASE("segment_ball: tangents, ends on the sphere, and a ball that is a point", "[geometry][degenerate]")
{
  auto const closed = [](Ball b, Point3d p, Point3d q) { return segment_meets<Filtered>(b, p, q); };
  auto const half_open = [](Ball b, Point3d p, Point3d q) { return segment_meets<Filtered, End::excluded>(b, p, q); };
  Ball const unit{{0, 0, 0}, 1}, point{{1, 1, 1}, 0};
  CHECK(half_open(unit, {-2, 1, 0}, {2, 1, 0}));
  CHECK_FALSE(closed(unit, {-2, std::nextafter(1, 2), 0}, {2, 1, 0x1p-1074}));
  CHECK(closed(unit, {-2, 0, 0}, {-1, 0, 0}));
  CHECK_FALSE(half_open(unit, {-2, 0, 0}, {-1, 0, 0}));
  CHECK_FALSE(half_open(unit, {-2, 1, 0}, {0, 1, 0}));  // stops at the tangent point
  CHECK(closed(unit, {-2, 1, 0}, {0, 1, 0}));
  CHECK(half_open(unit, {0, 1, 0}, {2, 1, 0}));  // starts at it
  CHECK(half_open(point, {0, 0, 0}, {2, 2, 2}));
  CHECK_FALSE(half_open(point, {0, 0, 0}, {1, 1, 1}));
  CHECK_FALSE(closed(point, {0, 0, 0}, {2, 2, std::nextafter(2, 3)}));
}

TEST_CASE("bounding_box: contains the ball exactly", "[geometry][conservative]")
{
  Random random(66);
  for (int i = 0; i < trials(2000); ++i) {
    auto const any = [&] { return std::ldexp(random.uniform(-1, 1), random.between(-1074, 1000)); };
    Ball const b{{any(), any(), any()}, std::fabs(any())};
    Box const box = bounding_box(b);
    RationalNumber const r(b.radius);
    for (auto const& [lo, c, hi] :
         {std::tuple(box.min.x, b.centre.x, box.max.x), std::tuple(box.min.y, b.centre.y, box.max.y)}) {
      REQUIRE(RationalNumber(lo) <= RationalNumber(c) - r);
      REQUIRE(RationalNumber(hi) >= RationalNumber(c) + r);
    }
  }
}
