#include "support/catch.hpp"
#include "support/random_scenes.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"

#include <algorithm>
#include <set>

using namespace visibility;
using namespace visibility::test;
using strong_occlusion::Granularity;

namespace {

std::set<std::string> visible_names(Scene const& scene, ViewCell const& cell, StrongOcclusion<>::Options options = {})
{
  PreparedScene const prepared(scene);
  std::set<std::string> names;
  for (auto const i : StrongOcclusion<>(options)(prepared, cell).visible) names.insert(scene.objects[i].name);
  return names;
}

Scene scene_of(std::vector<std::pair<std::string, Box>> const& boxes)
{
  SceneBuilder builder("test");
  for (auto const& [name, box] : boxes) {
    builder.begin_object(name);
    builder.add(box);
  }
  return builder.finish();
}

using Names = std::set<std::string>;
ViewCell const unit_cell(Box{{0, 0, 0}, {1, 1, 1}});

}  // namespace

TEST_CASE("strong occlusion: a wall hides what is wholly behind it and nothing that peeks", "[methods]")
{
  Box const wall{{3, -5, -5}, {4, 6, 6}};
  REQUIRE(visible_names(scene_of({{"wall", wall}, {"behind", {{6, 0, 0}, {7, 1, 1}}}}), unit_cell) == Names{"wall"});
  REQUIRE(visible_names(scene_of({{"wall", wall}, {"peeks", {{6, 0, 0}, {7, 1, 30}}}}), unit_cell) ==
          Names{"peeks", "wall"});
}

TEST_CASE("strong occlusion: coinciding faces do not hide each other", "[methods][degenerate]")
{
  Box const b{{3, 0, 0}, {4, 1, 1}};
  REQUIRE(visible_names(scene_of({{"one", b}, {"two", b}}), unit_cell) == Names{"one", "two"});
  // Nested, with the front face shared.
  Box const inner{{3, 0.25, 0.25}, {3.5, 0.75, 0.75}};
  REQUIRE(visible_names(scene_of({{"outer", b}, {"inner", inner}}), unit_cell) == Names{"inner", "outer"});
  // Nested without a shared front face: hidden.
  Box const deep{{3.25, 0.25, 0.25}, {4, 0.75, 0.75}};
  REQUIRE(visible_names(scene_of({{"outer", b}, {"deep", deep}}), unit_cell) == Names{"outer"});
}

TEST_CASE("strong occlusion: a box behind an abutting wall is hidden, one before it is not", "[methods][degenerate]")
{
  Box const wall{{3, -9, -9}, {4, 10, 10}};
  Scene const scene =
    scene_of({{"wall", wall}, {"before", {{2, 0, 0}, {3, 1, 1}}}, {"behind", {{4, 0, 0}, {5, 1, 1}}}});
  REQUIRE(visible_names(scene, unit_cell) == Names{"before", "wall"});
}

TEST_CASE("strong occlusion: touching counts -- a wall of exactly the shadow's size hides", "[methods][degenerate]")
{
  // From the unit cell, the shaft to this box crosses x = 2 in exactly [0, 1]^2, x = 4 in exactly [0, 1]^2.
  Box const target{{5, 0, 0}, {6, 1, 1}};
  REQUIRE(visible_names(scene_of({{"wall", {{2, 0, 0}, {2.5, 1, 1}}}, {"target", target}}), unit_cell) ==
          Names{"wall"});
  double const less = std::nextafter(1.0, 0.0);
  REQUIRE(visible_names(scene_of({{"wall", {{2, 0, 0}, {2.5, 1, less}}}, {"target", target}}), unit_cell) ==
          Names{"target", "wall"});
}

TEST_CASE("strong occlusion: an object that meets the closed cell is visible", "[methods][degenerate]")
{
  Box const around{{1, -5, -5}, {2, 6, 6}};  // touches the cell's face x = 1
  Scene const scene =
    scene_of({{"around", around}, {"corner", {{1, 1, 1}, {2, 2, 2}}}, {"in", {{0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}}}});
  REQUIRE(visible_names(scene, unit_cell) == Names{"around", "corner", "in"});
}

TEST_CASE("strong occlusion: parts hidden by different occluders make a hidden object", "[methods]")
{
  SceneBuilder builder("test");
  builder.begin_object("two parts");
  builder.add(Box{{10, -20, 0}, {11, -19, 1}});
  builder.add(Box{{10, 20, 0}, {11, 21, 1}});
  builder.begin_object("left");
  builder.add(Box{{5, -14, -9}, {6, -5, 9}});
  builder.begin_object("right");
  builder.add(Box{{5, 5, -9}, {6, 15, 9}});
  Scene const scene = builder.finish();
  REQUIRE(visible_names(scene, unit_cell, {.granularity = Granularity::object}).contains("two parts"));
  REQUIRE_FALSE(visible_names(scene, unit_cell, {.granularity = Granularity::part}).contains("two parts"));
}

TEST_CASE("strong occlusion: faces hidden by different occluders make a hidden object", "[methods][regression]")
{
  // Two faces of the target look at the cell. Each has a wall before it; neither wall hides the whole target.
  Scene const scene = scene_of({{"target", {{20, 20, 0}, {24, 24, 1}}},
                                {"left", {{18, 17, -9}, {19, 23, 9}}},
                                {"right", {{17, 18, -9}, {23, 19, 9}}}});
  for (auto const g : {Granularity::object, Granularity::part})
    REQUIRE(visible_names(scene, unit_cell, {.granularity = g}).contains("target"));
  for (auto const g : {Granularity::face, Granularity::triangle})
    for (bool const visible_first : {false, true})
      REQUIRE_FALSE(
        visible_names(scene, unit_cell, {.granularity = g, .visible_first = visible_first}).contains("target"));
}

TEST_CASE("strong occlusion: triangles of a wall cover it, and a ball has none", "[methods][regression]")
{
  // From the cell one sees the side wall of a prism, and of a ball, only beside a screen that covers most of it.
  auto const sees_target = [](auto&& add, Box const& screen) {
    SceneBuilder builder("test");
    builder.begin_object("target");
    add(builder);
    builder.begin_object("screen");
    builder.add(screen);
    return visible_names(builder.finish(), unit_cell, {.granularity = Granularity::triangle}).contains("target");
  };
  auto const prism = [](auto& b) { b.add(Prism{{{{20, 0}, {28, 0}, {28, 8}, {20, 8}}}, 0, 8}); };
  auto const ball = [](auto& b) { b.add(Ball{{24, 4, 4}, 4}); };
  // Open to the left, to the right, above and below.
  for (Box const& screen : {Box{{18, 2, -9}, {19, 20, 20}}, Box{{18, -9, -9}, {19, 6, 20}},
                            Box{{18, -9, -9}, {19, 20, 6}}, Box{{18, -9, 2}, {19, 20, 20}}}) {
    REQUIRE(sees_target(prism, screen));
    REQUIRE(sees_target(ball, screen));
  }
  Box const whole{{18, -9, -9}, {19, 20, 20}};
  REQUIRE_FALSE(sees_target(prism, whole));
  REQUIRE_FALSE(sees_target(ball, whole));
}

TEST_CASE("strong occlusion: every kind of body is an occluder", "[methods]")
{
  auto const hides = [](auto&& add) {
    SceneBuilder builder("test");
    builder.begin_object("occluder");
    add(builder);
    builder.begin_object("target");
    builder.add(Box{{20, 0, 0}, {21, 1, 1}});
    return !visible_names(builder.finish(), unit_cell).contains("target");
  };
  REQUIRE(hides([](auto& b) { b.add(Ball{{10, 0.5, 0.5}, 3}); }));
  REQUIRE_FALSE(hides([](auto& b) { b.add(Ball{{10, 0.5, 0.5}, 0.5}); }));
  REQUIRE(hides([](auto& b) {
            b.add(Prism{{{{9, -5}, {10, 0.5}, {9, 6}, {11, 0.5}}}, -5, 6});
          }) == false);  // two wings
  REQUIRE(hides([](auto& b) { b.add(Prism{{{{9, -5}, {11, -5}, {10, 6}}}, -5, 6}); }));
  REQUIRE(hides([](auto& b) { b.add(ConvexPolyhedron::from_box({{9, -5, -5}, {11, 6, 6}})); }));
  REQUIRE(hides([](auto& b) {
    for (auto const& p : {Point3d{10, -50, -50}, Point3d{10, 50, -50}, Point3d{10, 0, 50}}) b.add_vertex(p);
    b.add_triangle(0, 1, 2);
  }));
}

TEST_CASE("strong occlusion: a closed convex mesh occludes as a solid", "[methods]")
{
  // Cell and target are seen through two opposite slanted gaps: no single facet blocks, the solid does.
  SceneBuilder builder("test");
  auto const box = ConvexPolyhedron::from_box({{2, 0, 0}, {2.5, 1, 1}});
  builder.begin_object("mesh");
  for (auto const& v : box.vertices) builder.add_vertex(v);
  for (auto const& f : box.facets) builder.add_triangle(f.vertices[0], f.vertices[2], f.vertices[1]);  // inside out
  builder.begin_object("target");
  builder.add(Box{{5, 0, 0}, {6, 1, 1}});
  Scene const scene = builder.finish();
  REQUIRE(ConvexBodies(scene).bodies()[0].kind == ConvexBodies::Kind::polyhedron);
  REQUIRE(visible_names(scene, unit_cell) == Names{"mesh"});
}
