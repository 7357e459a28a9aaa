#include "support/catch.hpp"
#include "support/random_scenes.hpp"

#include "visibility/scene/convex_bodies.hpp"

using namespace visibility;
using namespace visibility::test;
using Kind = ConvexBodies::Kind;

namespace {

void add_mesh(SceneBuilder& builder, ConvexPolyhedron const& p)
{
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < p.vertices.size(); ++i) {
    auto const index = builder.add_vertex(p.vertices[i]);
    if (i == 0) first = index;
  }
  for (auto const& f : p.facets)
    builder.add_triangle(first + f.vertices[0], first + f.vertices[1], first + f.vertices[2]);
}

std::vector<Kind> kinds(Scene const& scene)
{
  std::vector<Kind> out;
  ConvexBodies const bodies(scene);
  for (auto const& b : bodies.bodies()) out.push_back(b.kind);
  return out;
}

}  // namespace

TEST_CASE("convex bodies: a closed convex mesh becomes one solid, an open or dented one stays triangles", "[scene]")
{
  SceneBuilder closed("closed"), open("open"), dented("dented");
  auto const box = ConvexPolyhedron::from_box({{0, 0, 0}, {2, 2, 2}});
  add_mesh(closed, box);
  REQUIRE(kinds(closed.finish()) == std::vector<Kind>{Kind::polyhedron});

  auto lid_off = box;
  lid_off.facets.pop_back();
  add_mesh(open, lid_off);
  REQUIRE(kinds(open.finish()) == std::vector<Kind>(11, Kind::triangle));

  auto dent = box;
  dent.vertices[7] = {0.5, 0.5, 0.5};
  add_mesh(dented, dent);
  REQUIRE(kinds(dented.finish()) == std::vector<Kind>(12, Kind::triangle));
}

TEST_CASE("convex bodies: two closed boxes in one mesh are two solids, next to loose triangles", "[scene]")
{
  SceneBuilder builder("test");
  add_mesh(builder, ConvexPolyhedron::from_box({{0, 0, 0}, {1, 1, 1}}));
  add_mesh(builder, ConvexPolyhedron::from_box({{3, 0, 0}, {4, 1, 1}}));
  auto const v = builder.add_vertex({9, 0, 0});
  builder.add_vertex({9, 1, 0});
  builder.add_vertex({9, 0, 1});
  builder.add_triangle(v, v + 1, v + 2);
  REQUIRE(kinds(builder.finish()) == std::vector<Kind>{Kind::polyhedron, Kind::polyhedron, Kind::triangle});
}

TEST_CASE("convex bodies: flush solids in one mesh stay two solids", "[scene][degenerate]")
{
  // They share a face, and so the coordinates of four corners, but no vertex.
  SceneBuilder builder("test");
  add_mesh(builder, ConvexPolyhedron::from_box({{0, 0, 0}, {1, 1, 1}}));
  add_mesh(builder, ConvexPolyhedron::from_box({{0, 0, 1}, {1, 1, 2}}));
  REQUIRE(kinds(builder.finish()) == std::vector<Kind>{Kind::polyhedron, Kind::polyhedron});
}

TEST_CASE("convex bodies: a mesh whose faces have vertices of their own is welded", "[scene]")
{
  SceneBuilder builder("test");
  auto const box = ConvexPolyhedron::from_box({{0, 0, 0}, {1, 1, 1}});
  for (auto const& f : box.facets) {
    auto const a = builder.add_vertex(box.vertices[f.vertices[0]]);
    builder.add_vertex(box.vertices[f.vertices[1]]);
    builder.add_vertex(box.vertices[f.vertices[2]]);
    builder.add_triangle(a, a + 1, a + 2);
  }
  REQUIRE(kinds(builder.finish()) == std::vector<Kind>{Kind::polyhedron});
}

TEST_CASE("convex bodies: a prism whose footprint is no polygon is seen but does not occlude", "[scene][degenerate]")
{
  SceneBuilder builder("test");
  builder.begin_object("bow tie");
  builder.add(Prism{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, 0, 1});
  builder.begin_object("box");
  builder.add(Box{{5, 5, 5}, {6, 6, 6}});
  Scene const scene = builder.finish();
  ConvexBodies const bodies(scene);
  REQUIRE(bodies.invalid_footprints() == 1);
  REQUIRE_FALSE(bodies.bodies()[0].occludes);
  REQUIRE(bodies.box(bodies.bodies()[0]) == Box{{0, 0, 0}, {2, 2, 1}});
  REQUIRE(bodies.box(bodies.bodies()[1]) == Box{{5, 5, 5}, {6, 6, 6}});
}

TEST_CASE("convex bodies: bodies lie inside their bounds and in object order", "[scene][law]")
{
  auto const seed = GENERATE(range(1, 21));
  CAPTURE(seed);
  Random random(static_cast<std::uint64_t>(seed));
  Scene const scene = grid_scene(random, 30, -9, 9, Mix::all);
  ConvexBodies const bodies(scene);
  std::size_t position = 0;
  for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
    REQUIRE_FALSE(bodies.bodies_of(o).empty());
    for (auto const& b : bodies.bodies_of(o)) {
      REQUIRE(b.object == o);
      std::vector<Point3d> vertices;
      bodies.append_vertices(b, vertices);
      for (auto const& v : vertices) REQUIRE(contains(bodies.bounds()[position], v));
      ++position;
    }
  }
  REQUIRE(position == bodies.bodies().size());
}
