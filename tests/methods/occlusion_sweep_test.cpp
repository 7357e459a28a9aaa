#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/geometry/segment_box.hpp"
#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/projection_map.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::extended_projection;

TEST_CASE("occlusion sweep: reprojection takes over what is covered from all of the cell, with its depth", "[methods]")
{
  ViewCell const cell(Box{{-1, -1, -1}, {1, 1, 0}});
  CellViews const views(frames[4], cell);
  ProjectionMap first(views, 5, Grid::covering({-16, -16}, {16, 16}, 512, 512));
  ConvexPart screen;
  for (auto const& p : Box{{-6, -6, 4}, {6, 6, 4}}.corners()) screen.push_back({p});
  REQUIRE(first.add(screen) > 0);
  ProjectionMap second(first, 10, Grid::covering({-32, -32}, {32, 32}, 512, 512));
  second.refresh();
  // The umbra of the screen: at w = 10, its edge 6 is seen at 1 + 5 * 11/5 = 12 from the eye x = 1,
  // w = -1, and farther out from the others.
  REQUIRE(second.hides(Box{{-1, -1, 10.5}, {1, 1, 11}}));
  REQUIRE(second.hides(Box{{10, 0, 10}, {11.5, 1, 10.1}}));
  REQUIRE(!second.hides(Box{{11, 0, 10}, {12.5, 1, 10.1}}));
  // The depth is that of the screen, where the paper takes that of the plane.
  REQUIRE(second.hides(Box{{-1, -1, 4.5}, {1, 1, 4.6}}));
  REQUIRE(!second.hides(Box{{-1, -1, 4}, {1, 1, 4.6}}));
}

namespace {

/// Whether no pixel of a map is covered nearer than that of another on the same raster.
bool knows_no_more(ProjectionMap const& a, ProjectionMap const& b)
{
  for (int y = 0; y < a.grid().height(); ++y)
    for (int x = 0; x < a.grid().width(); ++x)
      if (a.depths().at(x, y) < b.depths().at(x, y)) return false;
  return true;
}

}  // namespace

TEST_CASE("occlusion sweep: what a reprojected map hides is hidden", "[methods][conservative][law]")
{
  int hidden = 0, hidden_improved = 0;
  for (int trial = 0; trial < trials(300); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    ViewCell const cell(Box{{-1, -1, -random.uniform(0.1, 9)}, {1, random.uniform(-0.9, 1), 0}});
    CellViews const views(frames[4], cell);
    // Screens side by side and one before the other, some across planes or behind them.
    std::vector<Box> screens;
    for (int i = random.between(1, 6); i > 0; --i) {
      Point3d const low{random.uniform(-8, 2), random.uniform(-8, 2), random.uniform(1, 9)};
      screens.push_back({low, {low.x + random.uniform(2, 9), low.y + random.uniform(2, 9), low.z + random.unit()}});
    }
    double plane = random.uniform(2, 4);
    int const size = 16 << random.below(5);
    ProjectionMap map(views, plane, Grid::covering({-20, -20}, {20, 20}, size, size));
    for (int k = 0;; ++k) {
      for (auto const& b : screens)
        if (random.chance(0.7)) {
          ConvexPart all;
          for (auto const& p : b.corners()) all.push_back({p});
          map.add(cut(all, 0.01, plane));
          map.add(cut(all, plane, 100));
        }
      if (k == 3) break;
      plane *= random.uniform(1.05, 1.6);
      int const next_size = 16 << random.below(5);
      Grid const next =
        Grid::covering({-20 * plane / 2, -20 * plane / 2}, {20 * plane / 2, 20 * plane / 2}, next_size, next_size);
      ProjectionMap convolved(map, plane, next, Reprojection::convolution);
      map = ProjectionMap(map, plane, next);
      REQUIRE(knows_no_more(convolved, map));
      if (random.chance(0.3)) map = std::move(convolved);
    }
    map.refresh();
    for (int i = 0; i < 20; ++i) {
      Point3d const low{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(1, 15)};
      Box const box{low, {low.x + random.unit(), low.y + random.unit(), low.z + random.unit()}};
      bool const improved = map.hides_improved(box);
      if (!map.hides(box) && !improved) continue;
      ++hidden;
      hidden_improved += improved;
      for (int k = 0; k < 60; ++k) {
        Box const& c = cell.bounds();
        auto const at = [&](double l, double h) {
          return random.chance(0.4) ? (random.chance(0.5) ? l : h) : random.uniform(l, h);
        };
        Point3d const from{at(c.min.x, c.max.x), at(c.min.y, c.max.y), at(c.min.z, c.max.z)};
        Point3d const to{at(box.min.x, box.max.x), at(box.min.y, box.max.y), at(box.min.z, box.max.z)};
        REQUIRE(std::ranges::any_of(screens, [&](Box const& b) { return segment_meets<Filtered>(b, from, to); }));
      }
    }
  }
  CAPTURE(hidden, hidden_improved);
  REQUIRE(hidden > trials(100));
  REQUIRE(hidden_improved > trials(5));
}

TEST_CASE("occlusion sweep: leaves of trees hide trees behind them", "[methods]")
{
  Scene const scene = generate("forest,n=400,leaf=0.6");
  PreparedScene const prepared(scene);
  ViewCell const cell(Box{{-0.05, -0.05, 5.5}, {0.05, 0.05, 5.6}});
  Options options;
  options.resolution = 512;
  auto const swept = OcclusionSweep(options)(prepared, cell).visible.size();
  CAPTURE(swept);
  CHECK(2 * swept < scene.objects.size());
  // No leaf hides a tree alone.
  options.planes = 1;
  CHECK(OcclusionSweep(options)(prepared, cell).visible.size() > swept);
}

TEST_CASE("occlusion sweep: near the exact set in a city", "[methods]")
{
  Scene const scene = generate("city,n=2000");
  PreparedScene const prepared(scene);
  HeightField const field(scene);
  ViewCell const cell(Box{{-10, -10, 0}, {10, 10, 2}});
  auto const exact = Exact25d<>()(field, cell).visible;
  auto const set = OcclusionSweep()(prepared, cell).visible;
  auto const single = ExtendedProjection()(prepared, cell).visible;
  CAPTURE(exact.size(), set.size(), single.size());
  CHECK(std::ranges::includes(set, exact));
  CHECK(std::ranges::includes(single, exact));
  CHECK(2 * set.size() < 3 * exact.size());
}

TEST_CASE("occlusion sweep: a wall of no thickness in a plane hides what is behind it", "[methods][degenerate]")
{
  ViewCell const cell(Box{{-1, -1, -1}, {1, 1, 1}});
  // The plane at x = 6 is 5 from the cell; the wall may be alone in its group, or begin where a deep object does.
  for (bool const is_deep : {false, true}) {
    SceneBuilder builder("test");
    builder.begin_object("wall");
    auto const first = builder.add_vertex({6, -40, -30});
    builder.add_vertex({6, 40, -30});
    builder.add_vertex({6, 0, 60});
    builder.add_triangle(first, first + 1, first + 2);
    if (is_deep) builder.add(Box{{6, -40, -40}, {30, -39, -39}});
    builder.begin_object("behind");
    builder.add(Box{{8, -1, -1}, {9, 1, 1}});
    builder.begin_object("beside");
    builder.add(Box{{8, 60, -1}, {9, 61, 1}});
    Scene const scene = builder.finish();
    PreparedScene const prepared(scene);
    for (auto const& distances : {std::vector<double>{5}, {2, 5, 9}, {}}) {
      CAPTURE(is_deep, distances);
      Options options;
      options.distances = distances;
      REQUIRE(OcclusionSweep(options)(prepared, cell).visible == std::vector<std::uint32_t>{0, 2});
    }
  }
}
