#include "support.hpp"

#include "visibility/kernel/number_types.hpp"

using namespace visibility;

namespace {

RationalNumber squared_distance(Point3d const& a, Point3d const& b)
{
  auto const square = [](double p, double q) {
    RationalNumber const d = RationalNumber(p) - RationalNumber(q);
    return RationalNumber(d * d);
  };
  return square(a.x, b.x) + square(a.y, b.y) + square(a.z, b.z);
}

}  // namespace

TEST_CASE("spheres: 30^3 balls of radius 50 without one", "[generators]")
{
  auto const scene = generate("spheres");
  REQUIRE(scene.balls.size() == 26'999);
  REQUIRE(std::ranges::all_of(scene.balls, [](Ball const& b) { return b.radius == 50; }));
  REQUIRE(bounding_box(scene).min.z >= 0);
}

TEST_CASE("spheres: no two balls overlap, however tight the grid", "[generators]")
{
  auto const spacing = GENERATE("100", "100.5", "130", "200");
  CAPTURE(spacing);
  auto const scene = generate(std::string("spheres,n=7,spacing=") + spacing);
  for (std::size_t i = 0; i < scene.balls.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      REQUIRE(squared_distance(scene.balls[i].centre, scene.balls[k].centre) >= RationalNumber(100 * 100));
}

TEST_CASE("spheres: the place of the removed ball is free", "[generators]")
{
  auto const n = GENERATE(2, 3, 8, 9);
  CAPTURE(n);
  auto const scene = generate("spheres,n=" + std::to_string(n));
  REQUIRE(scene.balls.size() == static_cast<std::size_t>(n * n * n - 1));
  double const z = (n / 2 + 0.5) * 200;
  Box const free{{-99.99, -99.99, z - 99.99}, {99.99, 99.99, z + 99.99}};
  for (auto const& b : scene.balls) REQUIRE_FALSE(meet(bounding_box(b), free));
}

TEST_CASE("circles: balls in one plane, the middle one removed", "[generators]")
{
  auto const scene = generate("circles,n=9");
  REQUIRE(scene.balls.size() == 80);
  for (auto const& b : scene.balls) {
    REQUIRE(b.centre.z == 0);
    REQUIRE_FALSE(meet(bounding_box(b), Box{{-99.99, -99.99, 0}, {99.99, 99.99, 0}}));
  }
}

TEST_CASE("spheres: without jitter the grid is regular", "[generators]")
{
  auto const scene = generate("circles,n=3,jitter=0,spacing=150");
  for (auto const& b : scene.balls) {
    REQUIRE(std::abs(b.centre.x) * std::abs(b.centre.x - 150) * std::abs(b.centre.x + 150) == 0);
    REQUIRE(std::abs(b.centre.y) * std::abs(b.centre.y - 150) * std::abs(b.centre.y + 150) == 0);
  }
}
