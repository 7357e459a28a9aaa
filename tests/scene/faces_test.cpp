#include "support/catch.hpp"
#include "support/random_scenes.hpp"

#include "visibility/scene/faces.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

Point3q normal(Point3d const& a, Point3d const& b, Point3d const& c)
{
  auto const p = exact(a), q = exact(b), r = exact(c);
  Point3q const u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z};
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

}  // namespace

TEST_CASE("faces: polygons come with their vertices in order, so that a fan of triangles covers them", "[scene][law]")
{
  Random random(5);
  int polygons = 0;
  for (int seed = 1; seed <= 20; ++seed) {
    Scene const scene = grid_scene(random, 30, -9, 9, Mix::all);
    ConvexBodies const bodies(scene);
    ViewCell const cell(grid_box(random, -20, 20));
    for (auto const& body : bodies.bodies()) {
      if (!has_polygons(body)) continue;
      any_face_towards(cell, bodies, body, [&](std::span<Point3d const> face) {
        for (std::size_t i = 3; i < face.size(); ++i, ++polygons) {
          auto const m = normal(face[0], face[i - 2], face[i - 1]), n = normal(face[0], face[i - 1], face[i]);
          // Coplanar, and turning the same way; a straight corner gives no normal.
          REQUIRE(m.x * n.x + m.y * n.y + m.z * n.z >= 0);
          REQUIRE(m.x * n.y == m.y * n.x);
          REQUIRE(m.y * n.z == m.z * n.y);
        }
        return false;
      });
    }
  }
  REQUIRE(polygons > 500);
}

TEST_CASE("faces: a ball and the stand-in of an invalid prism are boxes, not polygons", "[scene][degenerate]")
{
  SceneBuilder builder("test");
  builder.begin_object("ball");
  builder.add(Ball{{0, 0, 0}, 1});
  builder.begin_object("bow tie");
  builder.add(Prism{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, 0, 1});
  Scene const scene = builder.finish();
  ConvexBodies const bodies(scene);
  ViewCell const cell(Box{{9, 9, 9}, {10, 10, 10}});
  for (auto const& body : bodies.bodies()) {
    REQUIRE_FALSE(has_polygons(body));
    any_face_towards(cell, bodies, body, [&](std::span<Point3d const> hull) {
      REQUIRE(hull.size() == 8);
      return true;
    });
  }
}
