#include "support.hpp"

#include <set>

using namespace visibility;

TEST_CASE("slanted: counts of the paper, as near as closed meshes come", "[generators]")
{
  auto const scene = generate("slanted");
  REQUIRE(scene.objects.size() == 3567);
  REQUIRE(scene.triangles.size() == 42'804);  // 42,801 in the paper
  auto const b = bounding_box(scene);
  double const area = (b.max.x - b.min.x) * (b.max.y - b.min.y);
  REQUIRE(std::abs(area - 1e6) < 0.05e6);  // 1 square kilometre
}

TEST_CASE("slanted: closed, exactly convex, outward, apart, and free in the middle", "[generators]")
{
  auto const scene = generate("slanted,n=150");
  scene.validate();
  for (auto const& o : scene.objects) {
    REQUIRE(test::is_closed(scene, o));
    REQUIRE(test::volume(scene, o) > 0);
    REQUIRE(bounding_box(scene, o).min.z == 0);
    REQUIRE_FALSE(meet(bounding_box(scene, o), Box{{-16.9, -16.9, 0}, {16.9, 16.9, 100}}));
  }
  REQUIRE(test::convex_solids(scene) == 150);
  REQUIRE(test::are_apart(scene));
}

TEST_CASE("slanted: walls are vertical, and no two corners share a height or a place", "[generators]")
{
  auto const scene = generate("slanted,n=150");
  std::set<double> heights, xs;
  for (std::size_t v = 0; v < scene.vertices.size(); v += 2) {  // foot, head
    auto const &foot = scene.vertices[v], &head = scene.vertices[v + 1];
    REQUIRE(foot.x == head.x);
    REQUIRE(foot.y == head.y);
    REQUIRE(foot.z == 0);
    REQUIRE((head.z >= 4 && head.z <= 8));
    REQUIRE(heights.insert(head.z).second);
    REQUIRE(xs.insert(head.x).second);
  }
}
