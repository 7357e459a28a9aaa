#include "support.hpp"

using namespace visibility;

TEST_CASE("forest: a thousand leaves to a tree", "[generators]")
{
  auto const scene = generate("forest,n=20");
  REQUIRE(scene.objects.size() == 20);
  for (auto const& o : scene.objects) REQUIRE(o.triangles.size() == 1000);
  scene.validate();
  REQUIRE(generate("forest,n=3,leaves=7,trunk=1").triangles.size() == 3 * 27);
}

TEST_CASE("forest: leaves lie inside the crown and have the size promised", "[generators]")
{
  auto const scene = generate("forest,n=30,leaves=300,trunk=1");
  double least = 1e9, greatest = 0;
  for (auto const& o : scene.objects) {
    // The trunk comes last; it ends in the middle of the crown, and its radius is 6 % of the crown's.
    Box trunk;
    for (auto i = o.triangles.last - 20; i < o.triangles.last; ++i) trunk.extend(bounding_box(scene.triangle(i)));
    REQUIRE(trunk.min.z == 0);
    Point3d const c{(trunk.min.x + trunk.max.x) / 2, (trunk.min.y + trunk.max.y) / 2, trunk.max.z};
    double const radius = (trunk.max.x - trunk.min.x) / 2 / 0.06, half_height = c.z * 0.35 / 0.65;
    least = std::min(least, radius);
    greatest = std::max(greatest, radius);
    double outermost = 0;
    for (auto i = o.triangles.first; i < o.triangles.last - 20; ++i) {
      auto const leaf = scene.triangle(i).vertices;
      for (std::size_t k = 0; k < 3; ++k) {
        double const x = (leaf[k].x - c.x) / radius, y = (leaf[k].y - c.y) / radius;
        double const z = (leaf[k].z - c.z) / half_height;
        outermost = std::max(outermost, x * x + y * y + z * z);
        auto const& next = leaf[(k + 1) % 3];
        double const dx = next.x - leaf[k].x, dy = next.y - leaf[k].y, dz = next.z - leaf[k].z;
        REQUIRE(std::abs(std::sqrt(dx * dx + dy * dy + dz * dz) - 0.3 * std::sqrt(3.0)) < 1e-9);
      }
    }
    REQUIRE(outermost <= 1 + 1e-9);
    REQUIRE(outermost > 0.9);
  }
  REQUIRE(least >= 2.5 * 0.75 - 1e-9);
  REQUIRE(greatest <= 2.5 * 1.25 + 1e-9);
  REQUIRE(least < 2.1);
  REQUIRE(greatest > 2.9);
}

TEST_CASE("forest: trunks are convex solids and leaves stay loose triangles", "[generators]")
{
  auto const scene = generate("forest,n=5,leaves=10,trunk=1");
  ConvexBodies const bodies(scene);
  auto const solids = std::ranges::count(bodies.bodies(), ConvexBodies::Kind::polyhedron, &ConvexBodies::Body::kind);
  auto const leaves = std::ranges::count(bodies.bodies(), ConvexBodies::Kind::triangle, &ConvexBodies::Body::kind);
  REQUIRE(solids == 5);
  REQUIRE(leaves == 50);
}

TEST_CASE("forest: no tree stands in the middle", "[generators]")
{
  auto const scene = generate("forest,n=40,leaves=1,trunk=1,jitter=1");
  for (auto const& o : scene.objects) {
    auto const last = scene.triangle(o.triangles.last - 1).vertices[0];  // on the trunk
    REQUIRE(std::max(std::abs(last.x), std::abs(last.y)) > 6 - 0.2);
  }
}
