#include "support/catch.hpp"
#include "support/random_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/geometry/segment_polyhedron.hpp"
#include "visibility/kernel/arithmetic.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/projection_map.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::extended_projection;

TEST_CASE("depth for each pixel: all lines meet the part by then, never later than by its one depth",
          "[methods][conservative]")
{
  std::int64_t pixels = 0, nearer = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial) + 40);
    ViewCell const cell(Box{{-1, -random.uniform(0, 1), -random.uniform(0.1, 4)}, {1, 1, 0}});
    CellViews const views(frames[4], cell);
    ConvexPolyhedron body = grid_polyhedron(random, -4, 5);
    // Stretched, before the plane or behind it.
    double const plane = random.chance(0.5) ? 12 : 3, wide = random.uniform(1, 4), deep = random.uniform(0.2, 0.6);
    std::vector<Point3d> corners;
    double const shear = random.uniform(-1, 1);
    for (auto const& p : body.vertices) {
      double const x = wide * p.x;
      corners.push_back({x, wide * p.y, std::clamp(7.5 + deep * p.z + shear * 0.2 * x, 3.0, 12.0)});
    }
    try {
      body = ConvexPolyhedron::hull(corners);
    } catch (std::invalid_argument const&) {
      continue;
    }
    ConvexPart part;
    for (auto const& p : body.vertices) part.push_back({p});
    int const size = 8 << random.below(4);
    auto const grid = Grid::covering({-14, -14}, {14, 14}, size, size);
    ProjectionMap by_part(views, plane, grid), by_pixel(views, plane, grid);
    by_part.add(part);
    by_pixel.add(part, PartDepth::pixel);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        double const z = by_pixel.depths().at(x, y), one = by_part.depths().at(x, y);
        REQUIRE(z <= one);
        if (!std::isfinite(z)) continue;
        REQUIRE(std::isfinite(one));
        ++pixels;
        nearer += z < one;
        Box const& c = cell.bounds();
        auto const at = [&](double l, double h) {
          return random.chance(0.5) ? (random.chance(0.5) ? l : h) : random.uniform(l, h);
        };
        Point3d const from{at(c.min.x, c.max.x), at(c.min.y, c.max.y), at(c.min.z, c.max.z)};
        double const u = at(grid.column_line(x), grid.column_line(x + 1)),
                     v = at(grid.row_line(y), grid.row_line(y + 1));
        // The end of the line is rounded; depths, being floats, mostly have more to spare than that.
        double const t = (z * (1 + 1e-9) - from.z) / (plane - from.z);
        Point3d const to{from.x + (u - from.x) * t, from.y + (v - from.y) * t, z * (1 + 1e-9)};
        REQUIRE(segment_meets<Filtered>(body, from, to));
      }
  }
  CAPTURE(pixels, nearer);
  CHECK(pixels > trials(1000));
  CHECK(4 * nearer > pixels);
}

TEMPLATE_TEST_CASE("depth for each pixel: an object beside the far end of a slanted wall, behind its near end",
                   "[methods]", ExtendedProjection, OcclusionSweep)
{
  // The wall leads from (16, -20) to (24, 20); what is hidden is behind its near part, before its far end.
  SceneBuilder builder("test");
  builder.begin_object("wall");
  std::vector<Point3d> corners;
  for (double const z : {-20, 20})
    for (double const x : {0.0, 0.25}) corners.insert(corners.end(), {{16 + x, -20, z}, {24 + x, 20, z}});
  builder.add(ConvexPolyhedron::hull(corners));
  builder.begin_object("behind");
  builder.add(Box{{21.75, -2, -1}, {22, -1, 1}});
  builder.begin_object("before");
  builder.add(Box{{20, 8, -1}, {20.5, 9, 1}});
  Scene const scene = builder.finish();
  PreparedScene const prepared(scene);
  ViewCell const cell(Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
  Options options;
  options.distances = {24};
  options.improved = false;
  CHECK(TestType(options)(prepared, cell).visible == std::vector<std::uint32_t>{0, 1, 2});
  options.depth = PartDepth::pixel;
  CHECK(TestType(options)(prepared, cell).visible == std::vector<std::uint32_t>{0, 2});
}
