#include "height_fields.hpp"
#include "meshes.hpp"

#include "support/catch.hpp"
#include "support/real_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/geometry/segment_box.hpp"
#include "visibility/scene/convex_bodies.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/grounded.hpp"
#include "visibility/scene/read_scene.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

using NT = RationalNumber;

std::size_t notes_with(Scene const& scene, std::string const& text)
{
  return static_cast<std::size_t>(
    std::ranges::count_if(scene.notes, [&](auto const& n) { return n.find(text) != std::string::npos; }));
}

void check_names(Scene const& scene, Scene const& low)
{
  low.validate();
  REQUIRE(low.source == scene.source);
  REQUIRE(low.objects.size() == scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) REQUIRE(low.objects[i].name == scene.objects[i].name);
}

/// Whether a body of the scene contains the point: a segment that starts there and leaves everything upwards tells all
/// bodies above it, so ask for the shortest possible one.
bool is_solid(Scene const& scene, Point3q const& p)
{
  ConvexBodies const bodies(scene);
  Point3q const q{p.x, p.y, p.z + NT(0x1p-100)};
  return std::ranges::any_of(bodies.bodies(), [&](auto const& b) {
    return b.occludes &&
           visit_shape(bodies, b, [&](auto const& shape) { return segment_meets<Rational>(shape, p, q); });
  });
}

}  // namespace

TEST_CASE("grounded: boxes, prisms and solids are carried down", "[scene]")
{
  Shape court = prism({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {2, 6}, {6, 6}, {6, 2}}}, 7);
  court.prisms[0].bottom = 3;
  Shape solid;
  solid.polyhedra.push_back(ConvexPolyhedron::from_box({{20, 0, 2}, {24, 4, 5}}));
  Shape const flat = box(30, 0, 30, 4, 5, 2);
  Scene const scene = scene_of({box(10, 0, 14, 4, 5, 1), court, solid, flat, box(40, 0, 44, 4, 6, 6)});
  Scene const low = grounded(scene);
  check_names(scene, low);
  REQUIRE(low.boxes == std::vector<Box>{{{10, 0, 1}, {14, 4, 5}}, {{30, 0, 1}, {30, 4, 5}}, {{40, 0, 1}, {44, 4, 6}}});
  REQUIRE(low.prisms.size() == 1);
  REQUIRE(low.prisms[0].rings == scene.prisms[0].rings);
  REQUIRE((low.prisms[0].bottom == 1 && low.prisms[0].top == 7));
  REQUIRE(low.polyhedra.size() == 1);
  REQUIRE(bounding_box(low.polyhedra[0]) == Box{{20, 0, 1}, {24, 4, 5}});
  REQUIRE(notes_with(low, "solid down to height 1") == 1);
}

TEST_CASE("grounded: the column under a triangle is a convex solid, whatever corners touch the ground", "[scene]")
{
  for (int on_ground = 0; on_ground < 8; ++on_ground) {
    auto const z = [&](int i) { return (on_ground >> i & 1) != 0 ? 0.0 : 3.0 + i; };
    Shape shape = mesh({triangle({0, 0, z(0)}, {3, 9, z(1)}, {9, 0, z(2)})});  // clockwise in plan
    Scene const low = grounded(scene_of({shape, box(20, 20, 21, 21, 1)}));
    if (on_ground == 7) {
      REQUIRE(low.polyhedra.empty());
      REQUIRE(low.triangles.size() == 1);
      continue;
    }
    REQUIRE(low.triangles.empty());
    REQUIRE(low.polyhedra.size() == 1);
    REQUIRE_NOTHROW(low.polyhedra[0].validate());
    REQUIRE(is_solid(low, {4, 3, NT(1, 100)}));
    REQUIRE_FALSE(is_solid(low, {4, 3, 6}));
  }
}

TEST_CASE("grounded: a vertical triangle is what lies below its upper boundary", "[scene]")
{
  auto const wall = [](double z) {
    return grounded(scene_of({mesh({triangle({0, 0, 2}, {8, 0, 2}, {4, 0, z})}), box(20, 20, 21, 21, 1)}));
  };
  for (double const z : {5.0, 2.0, 1.0}) {
    Scene const low = wall(z);
    REQUIRE(low.triangles.size() == (z > 2 ? 4 : 2));
    for (NT const& x : {NT(1, 3), NT(4), NT(23, 3)}) {
      NT const top = z > 2 ? NT(2) + (x < 4 ? x : NT(8) - x) * NT(3, 4) : NT(2);
      REQUIRE(is_solid(low, {x, 0, top}));
      REQUIRE(is_solid(low, {x, 0, 0}));
      REQUIRE_FALSE(is_solid(low, {x, 0, top + NT(1, 1000)}));
    }
  }
  Scene const line = grounded(scene_of({mesh({triangle({0, 0, 2}, {0, 0, 2}, {0, 0, 4})}), box(20, 20, 21, 21, 1)}));
  REQUIRE(line.triangles.size() == 1);
}

TEST_CASE("grounded: balls stay, prisms with invalid footprints become walls, and notes say so", "[scene][degenerate]")
{
  Scene scene = scene_of({prism({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, 3)});
  REQUIRE(notes_with(grounded(scene), "1 prisms with an invalid footprint") == 1);
  REQUIRE(grounded(scene).triangles.size() == 8);
  SceneBuilder builder("test");
  builder.note("kept");
  builder.begin_object("moon");
  builder.add(Ball{{0, 0, 9}, 1});
  scene = builder.finish();
  Scene const low = grounded(scene);
  REQUIRE(low.balls.size() == 1);
  REQUIRE(notes_with(low, "kept") == 1);
  REQUIRE(notes_with(low, "balls stay") == 1);
}

TEST_CASE("grounded: solid exactly below the upper surface", "[scene][oracle]")
{
  int solid = 0, air = 0;
  for (int seed = 1; seed <= trials(40); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    int const n = random.between(3, 6);
    auto shapes = random_shapes(random, random.between(1, 5), n);
    for (auto& s : shapes)
      for (auto& b : s.boxes) b.min.z = std::min(b.max.z, double(random.between(0, 3)));
    Scene const scene = scene_of(shapes);
    Scene const low = grounded(scene), twice = grounded(low);
    check_names(scene, low);
    HeightField const field(scene), low_field(low);
    REQUIRE(low_field.raised() == 0);
    REQUIRE(low_field.ground() == field.ground());
    for (int k = 0; k < 20; ++k) {
      Point2q const p{NT(2 * n) * NT(random.between(1, 10'006), 10'007), NT(2 * n) * NT(random.between(1, 96), 97)};
      auto const top = surface_over(field, p);
      REQUIRE(surface_over(low_field, p) == top);
      NT const z = NT(field.ground()) + NT(random.between(0, 500), 101);
      bool const below = top && z <= *top;
      REQUIRE(is_solid(low, {p.x, p.y, z}) == below);
      REQUIRE(is_solid(twice, {p.x, p.y, z}) == below);
      ++(below ? solid : air);
    }
  }
  REQUIRE(solid > 50);
  REQUIRE(air > 50);
}

TEST_CASE("grounded: a city on the ground stays as it is; real scenes come down", "[scene]")
{
  Scene const city = generate("city,n=100"), low = grounded(city);
  REQUIRE(HeightField(city).edges().size() == HeightField(low).edges().size());
  for (auto const& b : low.boxes) REQUIRE(b.min.z == 0);
  for (auto const* name : {"city/munich.ply", "city/lyon1.geojson", "cityjson/cjio_delft.json"}) {
    auto const path = real_scene(name);
    if (!path) continue;
    CAPTURE(name);
    Scene const scene = read_scene(*path), down = grounded(scene);
    check_names(scene, down);
    HeightField const before(scene), after(down);
    REQUIRE(after.raised() == 0);
    REQUIRE(after.edges().size() == before.edges().size());
  }
}
