#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/random_scenes.hpp"

#include "visibility/evidence/check_occludees.hpp"
#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/methods/ray_space/method.hpp"
#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/grounded.hpp"
#include "visibility/scene/moving_objects.hpp"
#include "visibility/scene/scene_builder.hpp"
#include "visibility/scene/write_scene.hpp"

#include <algorithm>
#include <sstream>

using namespace visibility;
using test::Random;

namespace {

using Method = std::function<PotentiallyVisibleSet(PreparedScene const&, ViewCell const&)>;

std::vector<std::pair<char const*, Method>> methods()
{
  extended_projection::Options coarse;
  coarse.resolution = 64;
  ray_space::Options pixels;
  pixels.resolution = 64;
  return {{"extended-projection", ExtendedProjection(coarse)},
          {"occlusion-sweep", OcclusionSweep(coarse)},
          {"ray-space", RaySpace(pixels)},
          {"strong-occlusion", StrongOcclusion<>({.granularity = strong_occlusion::Granularity::triangle})}};
}

std::vector<MovingObject> regions(Random& random, int n)
{
  std::vector<MovingObject> out;
  for (int i = 0; i < n; ++i)
    out.push_back({"region " + std::to_string(i), test::grid_box(random, -8, 8), std::uint64_t(random.below(100))});
  return out;
}

/// The positions of members that occlude, or of the others.
std::vector<std::uint32_t> part(Scene const& scene, std::vector<std::uint32_t> const& set, bool occludes)
{
  std::vector<std::uint32_t> out;
  for (auto const o : set)
    if (scene.objects[o].occludes == occludes) out.push_back(o);
  return out;
}

}  // namespace

TEST_CASE("moving objects: they come after the objects of the scene, and split takes them out again", "[scene]")
{
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    Scene const still = test::grid_scene(random, 12, -8, 8, test::Mix::all);
    auto const moving = regions(random, 3);
    Scene const all = with_moving_objects(still, moving);
    all.validate();
    REQUIRE(all.objects.size() == still.objects.size() + 3);
    auto const [first, second] = split(all);
    first.validate();
    second.validate();
    REQUIRE(first.boxes == still.boxes);
    REQUIRE(first.triangles == still.triangles);
    REQUIRE(first.objects.size() == still.objects.size());
    REQUIRE(second.objects.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      REQUIRE(second.boxes[i] == moving[i].region);
      REQUIRE(second.objects[i].name == moving[i].name);
      REQUIRE_FALSE(second.objects[i].occludes);
    }
    auto const polygons = polygon_counts(all, moving);
    REQUIRE(polygons.size() == all.objects.size());
    REQUIRE(polygons.back() == moving.back().polygons);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < still.objects.size(); ++i) sum += polygons[i];
    REQUIRE(sum == still.primitive_count());
  }
}

TEST_CASE("moving objects: whatever does not occlude is no occluder to any method, of any kind of primitive",
          "[methods][conservative]")
{
  // One wall that hides all behind it, if it occludes.
  auto const scene = [](int kind, bool occludes) {
    SceneBuilder b("test");
    if (occludes)
      b.begin_object("wall");
    else
      b.begin_occludee("wall");
    Box const wall{{10, -100, -100}, {11, 100, 100}};
    auto const c = wall.corners();
    switch (kind) {
    case 0: b.add(wall); break;
    case 1: b.add(Prism{{{{10, -100}, {11, -100}, {11, 100}, {10, 100}}}, -100, 100}); break;
    case 2: b.add(ConvexPolyhedron::hull(c)); break;
    case 3: b.add(Ball{{70, 0, 0}, 60}); break;
    default: {
      auto const v = b.add_vertex({10, -500, -300});
      b.add_vertex({10, 500, -300});
      b.add_vertex({10, 0, 500});
      b.add_triangle(v, v + 1, v + 2);
    }
    }
    b.begin_object("behind");
    b.add(Box{{150, -1, -1}, {151, 1, 1}});
    return b.finish();
  };
  ViewCell const cell(Box{{-1, -1, -1}, {1, 1, 1}});
  for (int kind = 0; kind < 5; ++kind) {
    CAPTURE(kind);
    Scene const solid = scene(kind, true), air = scene(kind, false);
    PreparedScene const prepared_solid(solid, InnerBodyOptions{}), prepared_air(air, InnerBodyOptions{});
    for (auto const& [name, method] : methods()) {
      CAPTURE(name);
      // Of a single triangle the sweep and ray space make little: one stands in the plane itself, one sees slopes.
      bool const hides = kind < 4 || name == std::string("extended-projection");
      if (hides) REQUIRE(method(prepared_solid, cell).visible == std::vector<std::uint32_t>{0});
      REQUIRE(method(prepared_air, cell).visible == std::vector<std::uint32_t>{0, 1});
    }
    // Rays pass through it, too.
    RayScene const rays(prepared_air);
    auto const hit = rays.first_hit({0, 0, 0}, {1, 0, 0});
    REQUIRE(hit.object == 1);
    REQUIRE(check(RayScene(prepared_solid), cell, std::vector<std::uint32_t>{0}, Guarantee::exact, {.rays = 2000})
              .missing.empty());
    REQUIRE(check(rays, cell, std::vector<std::uint32_t>{0}, Guarantee::exact, {.rays = 20000}).missing ==
            std::vector<std::uint32_t>{1});
  }
}

TEST_CASE("moving objects: methods keep all that witnesses prove visible, still or moving", "[methods][conservative]")
{
  Random random(2);
  ViewCell const cell(Box{{-1, -1, -1}, {1, 1, 1}});
  std::size_t hidden = 0;
  for (int trial = 0; trial < 12; ++trial) {
    CAPTURE(trial);
    Scene const still = test::grid_scene(random, 25, -8, 8, test::Mix::all, cell.bounds());
    Scene const all = with_moving_objects(still, regions(random, 6));
    Scene const moving = split(all).second;
    PreparedScene const prepared(all), prepared_still(still), prepared_moving(moving);
    Occludees const occludees(prepared_moving);
    RayScene const rays(prepared_still);
    auto const first = static_cast<std::uint32_t>(still.objects.size());
    for (auto const& [name, method] : methods()) {
      CAPTURE(name);
      auto const set = method(prepared, cell).visible;
      auto const of_still = part(all, set, true);
      auto of_moving = part(all, set, false);
      for (auto& o : of_moving) o -= first;
      REQUIRE_FALSE(check(rays, cell, of_still, Guarantee::conservative, {.rays = 3000}).fault);
      REQUIRE_FALSE(check(rays, occludees, cell, of_moving, Guarantee::conservative, {.rays = 3000}).fault);
      hidden += 6 - of_moving.size();
    }
  }
  REQUIRE(hidden > 0);
}

TEST_CASE("moving objects: the still objects of a set are those of the scene without what moves", "[methods][law]")
{
  // Where choices do not depend on what else is there: strong occlusion decides each object by itself.
  Random random(3);
  ViewCell const cell(Box{{-1, -1, -1}, {1, 1, 1}});
  for (int trial = 0; trial < 20; ++trial) {
    Scene const still = test::grid_scene(random, 25, -8, 8, test::Mix::all, cell.bounds());
    Scene const all = with_moving_objects(still, regions(random, 6));
    PreparedScene const with(all), without(still);
    REQUIRE(part(all, StrongOcclusion<>()(with, cell).visible, true) == StrongOcclusion<>()(without, cell).visible);
  }
}

TEST_CASE("moving objects: a region is visible iff a box in its place is that shows its faces to the exact method",
          "[methods][oracle]")
{
  Random random(4);
  ViewCell const cell(Box{{-1, -1, 0}, {1, 1, 2}});
  std::size_t visible = 0, hidden = 0;
  for (int trial = 0; trial < 15; ++trial) {
    CAPTURE(trial);
    SceneBuilder b("test");
    for (int i = 0; i < 25; ++i) {
      Box box = test::grid_box(random, -9, 9);
      box.min.z = 0;
      box.max.z = random.between(1, 4);
      if (box.min.x < 2 && box.max.x > -2 && box.min.y < 2 && box.max.y > -2) continue;
      b.begin_object("building " + std::to_string(i));
      b.add(box);
    }
    Scene const still = b.finish();
    for (int k = 0; k < 4; ++k) {
      Box region = test::grid_box(random, -9, 9);
      region.min.z = 0;
      region.max.z = random.between(1, 3);
      // As an occluder the box can hide only itself: of its own faces one that is seen remains.
      SceneBuilder joined("test");
      for (std::size_t i = 0; i < still.boxes.size(); ++i) {
        joined.begin_object(still.objects[i].name);
        joined.add(still.boxes[i]);
      }
      joined.begin_object("region");
      joined.add(region);
      Scene const as_occluder = joined.finish();
      auto const set = Exact25d<>()(HeightField(as_occluder), cell).visible;
      bool const expected = std::ranges::binary_search(set, static_cast<std::uint32_t>(still.boxes.size()));
      Scene const moving = split(with_moving_objects(still, std::vector<MovingObject>{{"region", region}})).second;
      PreparedScene const prepared(moving);
      auto const found = Exact25d<>()(HeightField(still), Occludees(prepared), cell).visible;
      REQUIRE(found.size() == (expected ? 1U : 0U));
      ++(expected ? visible : hidden);
    }
  }
  REQUIRE(visible > 0);
  REQUIRE(hidden > 0);
}

TEST_CASE("moving objects: what cannot take them says so in one line", "[scene][degenerate]")
{
  SceneBuilder b("test");
  b.begin_object("house");
  b.add(Box{{0, 0, 0}, {1, 1, 1}});
  Scene const house = b.finish();
  std::vector<MovingObject> const street{{"street", {{2, 0, 0}, {9, 1, 1}}}};
  Scene const all = with_moving_objects(house, street);
  REQUIRE_THROWS_AS(HeightField(all), BadInput);
  REQUIRE_THROWS_AS(grounded(all), BadInput);
  std::ostringstream out;
  REQUIRE_THROWS_AS(write_scene(out, all, SceneFileKind::native), BadInput);
  REQUIRE_THROWS_AS(with_moving_objects(house, std::vector<MovingObject>{{"house", {{2, 0, 0}, {9, 1, 1}}}}), BadInput);
  REQUIRE_THROWS_AS(with_moving_objects(house, std::vector<MovingObject>{{"x", {{2, 0, 0}, {1, 1, 1}}}}), BadInput);
}
