#include "support/catch.hpp"

#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>

using namespace visibility;
using exact_25d::Options;

namespace {

Box box(double x0, double y0, double x1, double y1, double h) { return {{x0, y0, 0}, {x1, y1, h}}; }
Prism prism(std::vector<Point2d> ring, double h) { return {{std::move(ring)}, 0, h}; }
ViewCell cell(double low, double high) { return ViewCell(Box{{-1, -1, low}, {1, 1, high}}); }

void add_upright_triangle(SceneBuilder& b, Point3d const& p, Point3d const& q, Point3d const& r)
{
  auto const i = b.add_vertex(p), j = b.add_vertex(q), k = b.add_vertex(r);
  b.add_triangle(i, j, k);
}

bool sees(Scene const& scene, ViewCell const& from, std::string const& name, Options const& options = {})
{
  HeightField const field(scene);
  auto const set = Exact25d<Filtered>(options)(field, from);
  CHECK(set.visible == Exact25d<Rational>(options)(field, from).visible);
  return std::ranges::any_of(set.visible, [&](auto o) { return scene.objects[o].name == name; });
}

}  // namespace

TEST_CASE("exact-2.5d: a roof seen only in front of a slanted top that it runs into", "[methods][regression]")
{
  SceneBuilder b("crease");
  b.begin_object("roof");
  b.add(box(8, -.55, 12, .55, 1));
  b.begin_object("left");
  b.add(prism({{4, -4}, {10.02, -.6}, {9.9, 0}, {4, 0}}, 1.001));
  b.begin_object("right");
  b.add(prism({{4, 0}, {9.9, 0}, {10.02, .6}, {4, 4}}, 1.001));
  b.begin_object("slanted");
  auto const p = b.add_vertex({9, -6, .5}), q = b.add_vertex({16, 0, 4}), r = b.add_vertex({9, 6, .5});
  b.add_triangle(p, q, r);
  CHECK(sees(b.finish(), cell(.5, 2), "roof"));
}

TEST_CASE("exact-2.5d: a curtain right under the cell is visible", "[methods][regression]")
{
  SceneBuilder b("curtain");
  b.begin_object("curtain");
  add_upright_triangle(b, {-.5, 0, 0}, {.5, 0, 0}, {.5, 0, 1});
  add_upright_triangle(b, {-.5, 0, 0}, {.5, 0, 1}, {-.5, 0, 1});
  b.begin_object("far");
  b.add(box(50, 50, 51, 51, 1));
  CHECK(sees(b.finish(), cell(2, 3), "curtain"));
}

TEST_CASE("exact-2.5d: a roof at the foot of a wall that reaches into the cell", "[methods][regression]")
{
  SceneBuilder b("intruder");
  b.begin_object("wall");
  b.add(box(-.5, .5, 20, 3, 10));
  b.begin_object("roof");
  b.add(box(5, .1, 6, 2, 1));
  b.begin_object("p1");
  b.add(prism({{4.9, .05}, {5.5, .05}, {5.5, .49}, {4.9, .502}}, 1.001));
  b.begin_object("p2");
  b.add(prism({{5.5, .05}, {6.1, .05}, {6.1, .502}, {5.5, .49}}, 1.001));
  b.begin_object("block");
  b.add(box(3, .3, 3.5, 2, 10));
  CHECK(sees(b.finish(), cell(.5, 2), "roof"));
}

TEST_CASE("exact-2.5d: a wall flush with a side of the cell, below it", "[methods][regression]")
{
  SceneBuilder b("flush");
  b.begin_object("low");
  b.add(box(1, -1, 3, 1, 1));
  b.begin_object("higher");
  b.add(box(1, -1, 3, 1, 1.5));
  Scene const scene = b.finish();
  Options without_samples;
  without_samples.sampled_lines = false;
  CHECK(sees(scene, cell(2, 3), "low"));
  CHECK(sees(scene, cell(2, 3), "low", without_samples));

  SceneBuilder slit("flush slit");
  slit.begin_object("low");
  slit.add(box(1, -1, 3, 1, 1));
  slit.begin_object("higher");
  slit.add(box(1, -1, 3, 1, 1.5));
  slit.begin_object("south");
  slit.add(prism({{0, -1}, {2, -1}, {2, .7}, {0, -.3}}, 1.2));
  slit.begin_object("north");
  slit.add(prism({{0, -.29}, {2, .700001}, {2, 1}, {0, 1}}, 1.2));
  CHECK(sees(slit.finish(), cell(2, 3), "low"));
}

TEST_CASE("exact-2.5d: a bridge is not a height field", "[methods][regression]")
{
  SceneBuilder b("bridge");
  b.begin_object("bridge");
  b.add(box(4, -5, 5, -4, 5));
  b.add(box(4, 4, 5, 5, 5));
  b.add(Box{{4, -5, 4}, {5, 5, 5}});
  b.begin_object("tower");
  b.add(box(10, -1, 11, 1, 2));
  b.add(Box{{10.25, -.5, 2}, {10.75, .5, 3}});  // stands on the lower box
  Scene const scene = b.finish();
  CHECK(HeightField(scene).raised() == 1);
}

TEST_CASE("exact-2.5d: a column below an overhanging cell does not make the set less than exact unawares",
          "[methods][regression]")
{
  std::vector<Point3d> corners;
  for (double const x : {-1, 1})
    for (double const y : {-1, 1}) corners.insert(corners.end(), {{2 * x, 2 * y, 3}, {x, y, 1}});
  SceneBuilder b("overhang");
  b.begin_object("inside");
  b.add(box(1.9, -.1, 1.95, .1, 1.5));
  b.begin_object("around");
  b.add(box(1.8, -1, 2, 1, 2));
  Scene const scene = b.finish();
  HeightField const field(scene);
  CHECK(Exact25d<Filtered>()(field, ViewCell::hull(corners)).guarantee == Guarantee::conservative);
}

TEST_CASE("exact-2.5d: two identical objects are both visible, by single wedges too", "[methods][regression]")
{
  SceneBuilder b("twins");
  b.begin_object("a");
  b.add(box(5, -3, 6, 3, 3));
  b.begin_object("b");
  b.add(box(5, -3, 6, 3, 3));
  Scene const scene = b.finish();
  Options wedges;
  wedges.occlusion = exact_25d::Occlusion::single_wedges;
  for (auto const* name : {"a", "b"}) {
    CHECK(sees(scene, cell(.5, 1), name));
    CHECK(sees(scene, cell(.5, 1), name, wedges));
  }
}
