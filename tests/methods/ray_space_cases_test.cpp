#include "support/box_scene.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"
#include "visibility/methods/ray_space/frame.hpp"
#include "visibility/methods/ray_space/method.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <array>
#include <cmath>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::ray_space;

// Scenes by hand, each with one thing to get right.
namespace {

std::vector<std::uint32_t> seen(std::vector<Box> const& all, Box const& cell, Options const& options = {})
{
  Scene const scene = box_scene(all);
  return RaySpace(options)(PreparedScene(scene), ViewCell(cell)).visible;
}

using Set = std::vector<std::uint32_t>;
Box const cell{{-1, -1, 0}, {1, 1, 2}};

}  // namespace

TEST_CASE("ray-space: a wall hides what is behind it, and not what stands above or beside", "[methods]")
{
  std::vector<Box> const scene{
    {{5, -20, 0}, {6, 20, 10}}, {{10, -2, 0}, {11, 2, 8}}, {{10, -2, 0}, {11, 2, 40}}, {{10, 40, 0}, {11, 80, 8}}};
  CHECK(seen(scene, cell) == Set{0, 2, 3});
}

TEST_CASE("ray-space: from behind the cell one sees over a wall that hides from its front", "[methods][regression]")
{
  // The appendix of the paper takes distances from the front of the cell; the third box would be hidden.
  Box const deep{{-20, -1, 0}, {0, 1, 2}};
  std::vector<Box> const scene{{{5, -200, 0}, {6, 200, 10}}, {{30, -2, 0}, {31, 2, 12}}, {{30, -2, 0}, {31, 2, 30}}};
  CHECK(seen(scene, deep) == Set{0, 2});
}

TEST_CASE("ray-space: what hangs is hidden neither by what is below nor by what is above", "[methods]")
{
  std::vector<Box> const scene{{{5, -20, 0}, {6, 20, 2}},      // a low wall
                               {{5, -20, 3}, {6, 20, 30}},     // another hangs over it
                               {{20, -2, 2.2}, {21, 2, 2.5}},  // seen between them
                               {{5, -20, -50}, {6, 20, -40}},  // so that there is room below the low wall
                               {{20, -2, 1}, {21, 2, 1.5}},    // behind the low wall
                               {{20, -2, 20}, {21, 2, 22}}};   // behind the hanging one
  CHECK(seen(scene, cell) == Set{0, 1, 2, 3});
}

TEST_CASE("ray-space: stacked boxes that touch occlude as one", "[methods]")
{
  std::vector<Box> scene{
    {{5, -40, 0}, {8, 40, 3}}, {{5.1, -40, 3}, {8, 40, 6}}, {{5, -40, 6}, {8, 40, 12}}, {{20, -2, 0}, {21, 2, 9}}};
  for (int const k : {1, 2, 4}) CHECK(seen(scene, cell, {.components = k}) == Set{0, 1, 2});
  scene[1].min.z = 3.5;  // a slit
  CHECK(seen(scene, cell).size() == 4);
}

TEST_CASE("ray-space: occluders fuse though their umbrae do not meet", "[methods]")
{
  // As in figure 3 of the paper: a comb, the slits of one row behind the teeth of the other. No tooth is wider than the
  // cell, so each has an umbra that ends close behind it.
  std::vector<Box> scene;
  for (int i = -30; i <= 30; ++i) {
    scene.push_back({{6, i * 1.0, 0}, {6.2, i * 1.0 + 0.9, 30}});
    scene.push_back({{6.2, i * 1.0 + 0.5, 0}, {6.4, i * 1.0 + 1.4, 30}});
  }
  scene.push_back({{40, -3, 0}, {41, 3, 5}});
  auto const last = static_cast<std::uint32_t>(scene.size() - 1);
  CHECK(std::ranges::count(seen(scene, cell, {.resolution = 2048}), last) == 0);
}

TEST_CASE("ray-space: two coinciding faces are both visible", "[methods][degenerate]")
{
  SceneBuilder builder("test");
  for (auto const* name : {"a", "b"}) {
    builder.begin_object(name);
    auto const first = builder.add_vertex({5, -20, -20});
    builder.add_vertex({5, 20, -20});
    builder.add_vertex({5, 0, 40});
    builder.add_triangle(first, first + 1, first + 2);
  }
  Scene const scene = builder.finish();
  CHECK(RaySpace()(PreparedScene(scene), ViewCell(cell)).visible == Set{0, 1});
  std::vector<Box> const same{{{5, -20, 0}, {6, 20, 10}}, {{5, -20, 0}, {6, 20, 10}}};
  CHECK(seen(same, cell) == Set{0, 1});
}

TEST_CASE("ray-space: a gap of one unit in the last place shows what is behind", "[methods][degenerate]")
{
  for (double const by : {0.0, 1e6}) {
    double const edge = std::nextafter(by + 0.25, HUGE_VAL);
    Box const c{{-1 + by, -1 + by, 0}, {1 + by, 1 + by, 2}};
    std::vector<Box> const scene{{{5 + by, -50 + by, 0}, {6 + by, 0.25 + by, 10}},
                                 {{5 + by, edge, 0}, {6 + by, 50 + by, 10}},
                                 {{10 + by, -2 + by, 0}, {11 + by, 2 + by, 3}}};
    CHECK(seen(scene, c, {.resolution = 2048}) == Set{0, 1, 2});
  }
}

TEST_CASE("ray-space: objects that meet the cell, and those right above it, are visible", "[methods]")
{
  std::vector<Box> const scene{{{0.5, -30, 0}, {0.6, 30, 50}}, {{1, 1, 2}, {3, 3, 4}}, {{-1, -1, 30}, {1, 1, 31}}};
  CHECK(seen(scene, cell) == Set{0, 1, 2});
}

TEST_CASE("ray-space: from within an object its inner bodies hide what is behind it, and nothing in it", "[methods]")
{
  // A closed L of two bars, a cell in one of them, a box in the corner of the L and one behind: of the bar along x a
  // chord is between the cell and the box, but there is no wall before the outer one.
  SceneBuilder builder("test");
  builder.begin_object("L");
  std::vector<Point2d> const ring{{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}};
  std::vector<std::uint32_t> corners;
  for (double const z : {0.0, 10.0})
    for (auto const& p : ring) corners.push_back(builder.add_vertex({p.x, p.y, z}));
  for (std::size_t i = 0; i < 6; ++i) {
    auto const j = (i + 1) % 6;
    builder.add_triangle(corners[i], corners[j], corners[j + 6]);
    builder.add_triangle(corners[i], corners[j + 6], corners[i + 6]);
  }
  for (auto const& t : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    auto const at = [&](int i, std::size_t level) { return corners[static_cast<std::size_t>(i) + level]; };
    builder.add_triangle(at(t[2], 0), at(t[1], 0), at(t[0], 0));
    builder.add_triangle(at(t[0], 6), at(t[1], 6), at(t[2], 6));
  }
  for (auto const& b : {Box{{2, 1, 1}, {3, 2, 2}}, Box{{2, -9, 1}, {3, -8, 2}}}) {
    builder.begin_object("box");
    builder.add(b);
  }
  Scene const scene = builder.finish();
  ViewCell const in_bar(Box{{2, 12, 1}, {4, 14, 2}});
  PreparedScene const prepared(scene, InnerBodyOptions{});
  REQUIRE(prepared.occluders().inner_count() >= 2);
  CHECK(RaySpace()(prepared, in_bar).visible == Set{0, 1});
}

TEST_CASE("ray-space: a cell that is no box is answered for its bounds", "[methods]")
{
  std::vector<Point3d> const corners{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 2}};
  Scene const scene = box_scene({{{5, -20, 0}, {6, 20, 10}}, {{10, -2, 0}, {11, 2, 8}}});
  PreparedScene const prepared(scene);
  CHECK(RaySpace()(prepared, ViewCell::hull(corners)).visible == RaySpace()(prepared, ViewCell(cell)).visible);
}

TEST_CASE("ray-space: coordinates out of all proportion leave everything visible", "[methods][degenerate]")
{
  std::vector<Box> const scene{{{5, -20, 0}, {6, 20, 10}}, {{1e300, -2, 0}, {1.5e300, 2, 8}}};
  CHECK(seen(scene, cell) == Set{0, 1});
  CHECK(seen(scene, {{-1e200, -1, 0}, {1, 1, 1}}) == Set{0, 1});
  CHECK(seen(scene, {{0, 0, 0}, {1e-200, 1, 1}}) == Set{0, 1});
}

TEST_CASE("ray-space: options out of range are refused", "[methods]")
{
  CHECK_THROWS_AS(RaySpace({.resolution = 4}), std::invalid_argument);
  CHECK_THROWS_AS(RaySpace({.components = 0}), std::invalid_argument);
  CHECK_THROWS_AS(RaySpace({.components = 17}), std::invalid_argument);
}

TEST_CASE("ray-space: every line from the cell has a pixel, whose slice of the cell holds the line's", "[methods][law]")
{
  for (int trial = 0; trial < trials(300); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    Box box;
    box.extend(random.point(-50, 50));
    box.extend(random.point(-50, 50));
    std::vector<Frame> frames;
    for (int f = 0; f < 4; ++f) frames.emplace_back(box, f, 16, 8);
    for (int i = 0; i < 100; ++i) {
      Point3d const p{random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y), box.min.z};
      double const angle = random.uniform(0, 6.283185307);
      Point3d const q{p.x + 1000 * std::cos(angle), p.y + 1000 * std::sin(angle), box.min.z};
      int found = 0;
      for (auto const& f : frames) {
        LocalPoint const a = f.local(p), b = f.local(q);
        double const t = (b.v - a.v) / (b.u - a.u), s = a.v - t * a.u;
        if (b.u < a.u || t < f.t(0) || t > f.t(f.rows())) continue;
        REQUIRE(std::fabs(s) <= f.s(f.columns()) * (1 + 1e-12));
        int row = 0, column = 0;
        while (row + 1 < f.rows() && f.t(row + 1) < t) ++row;
        while (column + 1 < f.columns() && f.s(column + 1) < s) ++column;
        auto const* const k = f.cell_slice(row, column);
        REQUIRE(k != nullptr);
        CHECK(k->u_in <= a.u + 1e-9);
        CHECK(k->u_out >= a.u - 1e-9);
        ++found;
      }
      CHECK(found >= 1);
    }
  }
}
