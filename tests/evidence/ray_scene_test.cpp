#include "scenes.hpp"
#include "support/catch.hpp"
#include "visibility/evidence/ray_scene.hpp"

using namespace visibility;

TEST_CASE("ray scene: a hit names object, face and point for every kind of primitive", "[evidence]")
{
  SceneBuilder b("kinds");
  b.begin_object("box"), b.add(Box{{5, -1, -1}, {6, 2, 2}});
  b.begin_object("ball"), b.add(Ball{{-5, 0, 0}, 1});
  b.begin_object("prism"), b.add(Prism{{{{-1, 5}, {2, 5}, {0, 7}}}, -1, 2});
  b.begin_object("triangle");
  b.add_triangle(b.add_vertex({-1, -1, 9}), b.add_vertex({2, -1, 9}), b.add_vertex({0, 3, 9}));
  test::TestScene const s(b.finish());
  RayScene const rays(*s.prepared);
  Point3d const from{0.25, 0, 0};
  struct Case {
    Point3d direction;
    std::uint32_t object;
    Face face;
    Point3d point;
  };
  for (auto const& c : {Case{{1, 0, 0}, 0, {Face::Kind::box, 0, 0}, {5, 0, 0}},
                        Case{{-2, 0, 0}, 1, {Face::Kind::sphere, 0, 0}, {-4, 0, 0}},
                        Case{{0, 3, 0}, 2, {Face::Kind::wall, 0, 0}, {0.25, 5, 0}},
                        Case{{0, 0, 1}, 3, {Face::Kind::triangle, 0, 0}, {0.25, 0, 9}}}) {
    auto const hit = rays.first_hit(from, c.direction);
    CAPTURE(c.object);
    REQUIRE(hit.object == c.object);
    CHECK(hit.face == c.face);
    CHECK_FALSE(hit.from_inside);
    CHECK(std::hypot(hit.point.x - c.point.x, hit.point.y - c.point.y, hit.point.z - c.point.z) < 1e-5);
  }
  CHECK_FALSE(rays.first_hit(from, {0, 0, -1}).hit());
  CHECK(rays.first_hit({5.5, 0, 0}, {1, 0, 0}).from_inside);
  CHECK(rays.first_hit({-5, 0, 0}, {1, 0, 0}).from_inside);
  CHECK(rays.first_hit({0, 5.5, 0}, {0, 0, 1}).from_inside);
}

TEST_CASE("ray scene: far from the origin a gap of a millimetre stays open", "[evidence][hard]")
{
  for (double const offset : {0.0, 1e6, 1e8}) {
    auto const s = test::boxes({Box{{offset + 5, offset - 9, -9}, {offset + 6, offset, 9}},
                                Box{{offset + 5, offset + 0.001, -9}, {offset + 6, offset + 9, 9}},
                                Box{{offset + 9, offset - 1, -1}, {offset + 10, offset + 1, 1}}});
    RayScene const rays(*s.prepared);
    CAPTURE(offset);
    CHECK(rays.first_hit({offset, offset + 0.0005, 0}, {1, 0, 0}).object == 2);
  }
}
