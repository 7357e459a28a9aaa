#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/drawing/plan_outline.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <array>

using namespace visibility;
using test::Random;

namespace {

/// How often the rings wind around a point that lies on none of their edges; exact for small whole numbers and halves.
int winding(PlanOutline const& outline, Point2d const& p)
{
  int sum = 0;
  for (auto const& ring : outline.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Point2d const &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      double const turn = (b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y);
      if (a.y <= p.y && turn > 0) ++sum;
      if (b.y <= p.y && turn < 0) --sum;
    }
  return sum;
}

/// -1 outside, 0 on the boundary, 1 inside.
int side(std::array<Point3d, 3> const& t, Point2d const& p)
{
  std::array<double, 3> turns{};
  for (std::size_t i = 0; i < 3; ++i) {
    auto const &a = t[i], &b = t[(i + 1) % 3];
    turns[i] = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }
  if (std::ranges::all_of(turns, [](double x) { return x > 0; }) ||
      std::ranges::all_of(turns, [](double x) { return x < 0; }))
    return 1;
  bool const mixed = std::ranges::any_of(turns, [](double x) { return x > 0; }) &&
                     std::ranges::any_of(turns, [](double x) { return x < 0; });
  return mixed ? -1 : 0;
}

Scene mesh(std::vector<std::array<Point3d, 3>> const& triangles)
{
  SceneBuilder builder("test");
  builder.begin_object("mesh");
  for (auto const& t : triangles) {
    auto const a = builder.add_vertex(t[0]), b = builder.add_vertex(t[1]), c = builder.add_vertex(t[2]);
    builder.add_triangle(a, b, c);
  }
  return builder.finish();
}

std::vector<std::array<Point3d, 3>> triangles_of(ConvexPolyhedron const& p)
{
  std::vector<std::array<Point3d, 3>> out;
  for (auto const& f : p.facets)
    out.push_back({p.vertices[f.vertices[0]], p.vertices[f.vertices[1]], p.vertices[f.vertices[2]]});
  return out;
}

}  // namespace

TEST_CASE("plan outline: of any triangles, exactly the points that one covers are wound around", "[drawing][law]")
{
  std::size_t inside = 0, outside = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    auto const whole = [&](int n) { return double(random.below(n)); };
    std::vector<std::array<Point3d, 3>> triangles(static_cast<std::size_t>(random.between(1, 12)));
    for (auto& t : triangles)
      for (auto& p : t) p = {whole(6), whole(6), whole(3)};  // crowded: shared, doubled, upright and flat ones
    Scene const scene = mesh(triangles);
    auto const outline = plan_outline(scene, scene.objects[0]);
    for (int k = 0; k < 100; ++k) {
      Point2d const p{whole(24) / 4 + 1.0 / 16, whole(24) / 4 + 3.0 / 64};
      std::vector<int> sides;
      for (auto const& t : triangles) sides.push_back(side(t, p));
      if (std::ranges::count(sides, 0) > 0) continue;
      bool const covered = std::ranges::count(sides, 1) > 0;
      ++(covered ? inside : outside);
      REQUIRE((winding(outline, p) != 0) == covered);
    }
  }
  REQUIRE((inside > 1000 && outside > 1000));
}

TEST_CASE("plan outline: a closed box of triangles is its rectangle, once", "[drawing]")
{
  auto triangles = triangles_of(ConvexPolyhedron::from_box({{1, 2, 0}, {5, 4, 9}}));
  Scene const closed = mesh(triangles);
  auto const outline = plan_outline(closed, closed.objects[0]);
  REQUIRE(outline.rings.size() == 1);
  REQUIRE(outline.rings[0].size() == 4);
  REQUIRE(winding(outline, {3, 3}) == 1);

  triangles.erase(triangles.begin());  // open: still the same points, though some may be wound around twice
  Scene const open = mesh(triangles);
  auto const of_open = plan_outline(open, open.objects[0]);
  REQUIRE(winding(of_open, {2, 3.5}) != 0);
  REQUIRE(winding(of_open, {4, 2.5}) != 0);
  REQUIRE(winding(of_open, {6, 3}) == 0);
}

TEST_CASE("plan outline: holes stay open, discs are discs, upright triangles a line", "[drawing]")
{
  SceneBuilder builder("test");
  builder.begin_object("ring");
  builder.add(Prism{{{{0, 0}, {0, 9}, {9, 9}, {9, 0}}, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}}, 0, 1});
  builder.begin_object("ball");
  builder.add(Ball{{20, 1, 5}, 2});
  builder.begin_object("curtain");
  auto const a = builder.add_vertex({30, 0, 0}), b = builder.add_vertex({34, 2, 0}), c = builder.add_vertex({32, 1, 7});
  builder.add_triangle(a, b, c);
  Scene const scene = builder.finish();
  auto const ring = plan_outline(scene, scene.objects[0]);
  REQUIRE(winding(ring, {1, 1.5}) == 1);
  REQUIRE(winding(ring, {4, 4.5}) == 0);
  auto const ball = plan_outline(scene, scene.objects[1]);
  REQUIRE((ball.rings.empty() && ball.discs.size() == 1));
  REQUIRE(ball.discs[0].radius == 2);
  auto const curtain = plan_outline(scene, scene.objects[2]);
  REQUIRE(curtain.rings == std::vector<std::vector<Point2d>>{{{30, 0}, {34, 2}}});
}
