#include "slice_projector.hpp"

#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/evidence/check.hpp"
#include "visibility/geometry/segment_triangle.hpp"
#include "visibility/kernel/arithmetic.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <numbers>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::extended_projection;

namespace {

void add_triangle(SceneBuilder& builder, std::array<Point3d, 3> const& corners)
{
  std::array<std::uint32_t, 3> v{};
  std::ranges::transform(corners, v.begin(), [&](Point3d const& p) { return builder.add_vertex(p); });
  builder.add_triangle(v[0], v[1], v[2]);
}

void add_quadrilateral(SceneBuilder& builder, std::array<Point3d, 4> const& p)
{
  add_triangle(builder, {p[0], p[1], p[2]});
  add_triangle(builder, {p[0], p[2], p[3]});
}

/// A ring about the x axis, of so many sides, x in [near, far], radii of its sides' corners.
void add_ring(SceneBuilder& builder, int sides, double near, double far, double hole, double outer)
{
  auto const at = [&](int i, double x, double r) {
    double const angle = 2 * std::numbers::pi * ((i % sides) + 0.5) / sides;
    return Point3d{x, r * std::cos(angle), r * std::sin(angle)};
  };
  for (int i = 0; i < sides; ++i) {
    auto const quad = [&](double x0, double r0, double x1, double r1) {
      add_quadrilateral(builder, {at(i, x0, r0), at(i + 1, x0, r0), at(i + 1, x1, r1), at(i, x1, r1)});
    };
    quad(near, hole, near, outer);
    quad(near, outer, far, outer);
    quad(far, outer, far, hole);
    quad(far, hole, near, hole);
  }
}

/// The surface of a box as triangles: sides may be divided by a point that others do not have, and the lower half or
/// the bottom may be open.
void add_walls(std::vector<std::array<Point3d, 3>>& facets, Random& random, Box const& b)
{
  auto const quad = [&](Point3d const& p, Point3d const& q, Point3d const& r, Point3d const& s) {
    if (random.chance(0.3)) {
      Point3d const m{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
      facets.insert(facets.end(), {{p, m, s}, {m, q, r}, {m, r, s}});
    } else {
      facets.insert(facets.end(), {{p, q, r}, {p, r, s}});
    }
  };
  bool const is_open = random.chance(0.3);
  auto const wall = [&](double x0, double y0, double x1, double y1) {
    double const middle = (b.min.z + b.max.z) / 2;
    if (!(is_open && random.chance(0.5)))
      quad({x0, y0, b.min.z}, {x1, y1, b.min.z}, {x1, y1, middle}, {x0, y0, middle});
    quad({x0, y0, middle}, {x1, y1, middle}, {x1, y1, b.max.z}, {x0, y0, b.max.z});
  };
  wall(b.min.x, b.min.y, b.max.x, b.min.y);
  wall(b.max.x, b.min.y, b.max.x, b.max.y);
  wall(b.max.x, b.max.y, b.min.x, b.max.y);
  wall(b.min.x, b.max.y, b.min.x, b.min.y);
  for (double const z : {b.min.z, b.max.z})
    if (z == b.max.z || random.chance(0.7))
      quad({b.min.x, b.min.y, z}, {b.max.x, b.min.y, z}, {b.max.x, b.max.y, z}, {b.min.x, b.max.y, z});
}

/// Triangles that enclose something modulo 2: the surfaces of random tetrahedra and boxes on a small grid, so that they
/// overlap, nest, touch, share facets and pass through each other.
void add_cycle(SceneBuilder& builder, Random& random, Point3d const& middle, int reach)
{
  auto const corner = [&] {
    Point3d const p = random.grid_point(-reach, reach);
    return Point3d{middle.x + p.x, middle.y + p.y, middle.z + p.z};
  };
  std::vector<std::array<Point3d, 3>> facets;
  std::vector<Point3d> used;
  for (int i = random.between(1, 5); i > 0; --i) {
    if (random.chance(0.6)) {
      std::array<Point3d, 4> p{corner(), corner(), corner(), corner()};
      for (auto& q : p)
        if (!used.empty() && random.chance(0.6)) q = used[std::size_t(random.below(int(used.size())))];
      used.insert(used.end(), p.begin(), p.end());
      for (std::size_t k = 0; k < 4; ++k) facets.push_back({p[k], p[(k + 1) % 4], p[(k + 2) % 4]});
    } else {
      Box b;
      b.extend(corner());
      b.extend(corner());
      auto const c = b.corners();
      used.insert(used.end(), c.begin(), c.end());
      add_walls(facets, random, b);
    }
  }
  for (auto const& f : facets) add_triangle(builder, f);
}

std::vector<Triangle> triangles_of(Scene const& scene)
{
  std::vector<Triangle> out;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) out.push_back(scene.triangle(i));
  return out;
}

bool blocked(std::vector<Triangle> const& triangles, Point3d const& from, Point3d const& to)
{
  return std::ranges::any_of(triangles, [&](Triangle const& t) { return segment_meets<Filtered>(t, from, to); });
}

/// The point of the scene that a frame that is not turned has at (u, v, w).
Point3d in_scene(Frame const& frame, Point3d const& p)
{
  Point3d out{0, 0, 0};
  out.*frame.u = p.x;
  out.*frame.v = p.y;
  out.*frame.w = frame.up ? p.z : -p.z;
  return out;
}

double low_or_high(Random& random, double low, double high)
{
  return random.chance(0.4) ? (random.chance(0.5) ? low : high) : random.uniform(low, high);
}

}  // namespace

TEST_CASE("mesh slices: every sight line to a covered pixel of any closed mesh has met it", "[methods][conservative]")
{
  std::int64_t pixels = 0, lines = 0, slices = 0, above_floor = 0;
  for (int trial = 0; trial < trials(600); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial) + 900);
    SceneBuilder builder("test");
    builder.begin_object("mesh");
    // Above and before the cell, or far away; the plane through vertices as often as not.
    Frame const& frame = frames[std::size_t(random.below(6))];
    Point3d const middle = in_scene(frame, {0, 0, 12});
    add_cycle(builder, random, middle, 4);
    Scene const scene = builder.finish();
    PreparedScene const prepared(scene, InnerBodyOptions{});
    Point3d low{-random.uniform(0, 3), -random.uniform(0, 3), random.chance(0.3) ? -4 : random.uniform(-9, 3)};
    if (random.chance(0.2))
      low = random.grid_point(-3, 3), low = {middle.x + low.x, middle.y + low.y, middle.z + low.z};
    ViewCell const cell(Box{low, {low.x + 1, low.y + 1, low.z + random.uniform(0.5, 3)}});
    CellViews const views(frame, cell);
    double const plane = random.chance(0.6) ? random.between(9, 16) : random.uniform(9, 16);
    if (!(plane > views.near)) continue;
    int const size = 8 << random.below(4);
    double const half = random.chance(0.5) ? 8 : random.uniform(3, 8);
    ProjectionMap map(views, plane, Grid::covering({-half, -half}, {half, half}, size, size));
    OccluderProjector const occluders(prepared, cell);
    SliceProjector projector(prepared, cell, occluders);
    pixels += projector.add(0, map);
    slices += std::int64_t(projector.count());
    auto const triangles = triangles_of(scene);
    Grid const& g = map.grid();
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        if (map.depths().at(x, y) == DepthMap<float>::empty) continue;
        REQUIRE(map.depths().at(x, y) >= float(plane - views.near));
        for (int k = 0; k < 2; ++k) {
          Point3d const to = in_scene(frame, {low_or_high(random, g.column_line(x), g.column_line(x + 1)),
                                              low_or_high(random, g.row_line(y), g.row_line(y + 1)), plane});
          Box const& c = cell.bounds();
          Point3d const from{low_or_high(random, c.min.x, c.max.x), low_or_high(random, c.min.y, c.max.y),
                             low_or_high(random, c.min.z, c.max.z)};
          // Below the ground no sight line goes; from the floor itself none starts.
          if (frame.has_vertical_v() && to.z < occluders.ground()) continue;
          for (auto const& shell : prepared.shells().of_object(0))
            if (from.z == shell.floor) goto next;
          REQUIRE(blocked(triangles, from, to));
          ++lines;
          above_floor += std::ranges::any_of(prepared.shells().of_object(0),
                                             [](EnclosingShell const& s) { return std::isfinite(s.floor); });
        next:;
        }
      }
  }
  CAPTURE(pixels, lines, slices, above_floor);
  CHECK(pixels > trials(4000));
  CHECK(lines > trials(4000));
  CHECK(slices > trials(200));
  CHECK(above_floor > trials(100));
}

TEMPLATE_TEST_CASE("mesh slices: a ring hides what is behind it, and not what is seen through its hole", "[methods]",
                   ExtendedProjection, OcclusionSweep)
{
  ViewCell const cell(Box{{-1, -1, -1}, {1, 1, 1}});
  constexpr int around = 16;
  SceneBuilder builder("test");
  builder.begin_object("ring");
  add_ring(builder, 24, 8, 9, 3, 12);
  builder.begin_object("in the hole");
  builder.add(Box{{14, -0.5, -0.5}, {15, 0.5, 0.5}});
  for (int i = 0; i < around; ++i) {
    double const angle = 2 * std::numbers::pi * i / around, y = 9 * std::cos(angle), z = 9 * std::sin(angle);
    builder.begin_object("behind");
    builder.add(Box{{14, y - 0.4, z - 0.4}, {15, y + 0.4, z + 0.4}});
  }
  Scene const scene = builder.finish();
  PreparedScene const prepared(scene, InnerBodyOptions{});
  Options options;
  auto const set = TestType(options)(prepared, cell);
  REQUIRE(set.visible == std::vector<std::uint32_t>{0, 1});
  REQUIRE(set.statistics.at("slices") > 0);
  REQUIRE(check(prepared, cell, set.visible, Guarantee::conservative, {.rays = 20'000, .threads = 1}).missing.empty());
  // Bodies inside the ring are prisms along z, and leave seams.
  options.slices = false;
  auto const without = TestType(options)(prepared, cell);
  CAPTURE(without.visible.size());
  REQUIRE(without.visible.size() > set.visible.size() + around / 4);
  REQUIRE(without.statistics.at("slices") == 0);
}

TEMPLATE_TEST_CASE("mesh slices: the hunt finds nothing missing among closed meshes of any shape",
                   "[methods][conservative]", ExtendedProjection, OcclusionSweep)
{
  std::size_t fewer = 0, turned_slices = 0, tilted_slices = 0;
  for (int trial = 0; trial < trials(40); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial) + 70);
    SceneBuilder builder("test");
    for (int i = random.between(2, 12); i > 0; --i) {
      Point3d middle = random.grid_point(-12, 12);
      while (std::max({std::fabs(middle.x), std::fabs(middle.y), std::fabs(middle.z)}) < 9)
        middle = random.grid_point(-12, 12);
      builder.begin_object("mesh");
      add_cycle(builder, random, middle, random.between(4, 7));
    }
    for (int i = 0; i < 200; ++i) {
      Point3d p = random.point(-30, 30);
      while (std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) < 16) p = random.point(-30, 30);
      builder.begin_object("behind");
      builder.add(Box{p, {p.x + 0.5, p.y + 0.5, p.z + 0.5}});
    }
    Scene const scene = builder.finish();
    PreparedScene const prepared(scene, InnerBodyOptions{});
    // A turned cell has planes along itself.
    Box const box{{-0.5, -0.8, -0.5}, {0.5, 0.8, 0.5}};
    std::vector<Point3d> corners;
    bool const is_tilted = random.chance(0.3), is_turned = is_tilted || random.chance(0.4);
    for (auto const& p : box.corners()) {
      Point3d const q{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z};
      corners.push_back(is_tilted ? Point3d{q.x, 0.96 * q.y - 0.28 * q.z, 0.28 * q.y + 0.96 * q.z} : q);
    }
    ViewCell const cell = is_turned ? ViewCell::hull(corners) : ViewCell(box);
    Options options;
    options.resolution = 16 << random.below(5);
    options.directions = is_tilted || random.chance(0.5) ? Directions::cell : Directions::automatic;
    if (random.chance(0.4)) options.reprojection = Reprojection::convolution;
    if (random.chance(0.5))
      for (int i = random.between(1, 6); i > 0; --i) options.distances.push_back(random.between(2, 30) * 0.5);
    auto const set = TestType(options)(prepared, cell);
    auto const report = check(prepared, cell, set.visible, Guarantee::conservative, {.rays = 20'000, .threads = 1});
    REQUIRE(report.missing.empty());
    if (is_turned && options.directions == Directions::cell)
      (is_tilted ? tilted_slices : turned_slices) += static_cast<std::size_t>(set.statistics.at("slices"));
    options.slices = false;
    fewer += TestType(options)(prepared, cell).visible.size() > set.visible.size();
  }
  CAPTURE(fewer, turned_slices, tilted_slices);
  CHECK(fewer > 0);
  CHECK(turned_slices > 0);
  CHECK(tilted_slices > 0);
}
