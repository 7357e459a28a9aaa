#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/evidence/check.hpp"
#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/extended_projection/cell_views.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::extended_projection;

namespace {

/// A turn of the plan, and a move after it; rounded.
struct Placement {
  double angle = 0, x = 0, y = 0;

  Point2d operator()(double px, double py) const
  {
    double const c = std::cos(angle), s = std::sin(angle);
    return {x + c * px - s * py, y + s * px + c * py};
  }
  std::vector<Point2d> operator()(Box const& b) const
  {
    return {(*this)(b.min.x, b.min.y), (*this)(b.max.x, b.min.y), (*this)(b.max.x, b.max.y), (*this)(b.min.x, b.max.y)};
  }
};

ViewCell placed_cell(Placement const& place, Box const& box)
{
  std::vector<Point3d> points;
  for (auto const& p : place(box))
    for (double const z : {box.min.z, box.max.z}) points.push_back({p.x, p.y, z});
  return ViewCell::hull(points);
}

/// Houses along streets of a grid, all turned and moved together.
Scene placed_town(Placement const& place, Random& random, int rows)
{
  SceneBuilder b("town");
  for (int i = -rows; i <= rows; ++i)
    for (int j = -rows; j <= rows; ++j) {
      Box const box{{40. * i - 19.5, 40. * j - 17 + random.uniform(0, 3), 0},
                    {40. * i + 19.5, 40. * j + 17, random.uniform(15, 20)}};
      b.begin_object("house");
      b.add(Prism{{place(box)}, 0, box.max.z});
    }
  return b.finish();
}

/// A street cell between rows of houses.
constexpr Box street{{-60, 18, .5}, {60, 22, 2}};

/// A rotation of space about a random axis.
Turn random_rotation(Random& random)
{
  double q[4], size = 0;
  for (double& x : q) x = random.uniform(-1, 1), size += x * x;
  for (double& x : q) x /= std::sqrt(size);
  auto const [w, x, y, z] = q;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

/// The corners of a box, turned and moved; rounded.
std::vector<Point3d> tilted_corners(Turn const& turn, Box const& box, Point3d const& move)
{
  std::vector<Point3d> out;
  for (auto const& c : box.corners()) {
    Point3d const p = turn(c);
    out.push_back({p.x + move.x, p.y + move.y, p.z + move.z});
  }
  return out;
}

/// A box about the origin: a cube, long, thin, flat, or any.
Box any_cell_box(Random& random)
{
  auto const half = [&] { return std::pow(10, random.uniform(-1.5, 1)); };
  double const one = half();
  Point3d const h = random.chance(0.2) ? Point3d{one, one, one} : Point3d{half(), half(), half()};
  return {{-h.x, -h.y, -h.z}, {h.x, h.y, h.z}};
}

/// Six walls about the origin at 30, each of five slabs that overlap, so that only together they hide the 60 boxes
/// behind, all turned and moved together.
Scene tilted_walls(Turn const& turn, Point3d const& move, Random& random)
{
  SceneBuilder b("walls");
  auto const add = [&](char const* name, Box const& box) {
    b.begin_object(name);
    b.add(ConvexPolyhedron::hull(tilted_corners(turn, box, move)));
  };
  double const d = 30;
  for (double Point3d::*axis : {axis_x, axis_y, axis_z})
    for (double const side : {-1., 1.}) {
      double Point3d::*const along = axis == axis_x ? axis_y : axis_x;
      for (int i = -2; i <= 2; ++i) {
        Box box{{-d, -d, -d}, {d, d, d}};
        double const near = side * (d + random.uniform(0, 2)), far = near + side * 3;
        box.min.*axis = std::min(near, far), box.max.*axis = std::max(near, far);
        box.min.*along = d * 0.4 * (i - 0.6), box.max.*along = d * 0.4 * (i + 0.6);
        add("slab", box);
      }
      for (int i = 0; i < 10; ++i) {
        Point3d at = random.point(-25, 25);
        at.*axis = side * random.uniform(50, 90);
        add("box", {at, {at.x + random.uniform(1, 6), at.y + random.uniform(1, 6), at.z + random.uniform(1, 6)}});
      }
    }
  return b.finish();
}

bool within(RationalNumber const& x, double value, double error)
{
  return x >= RationalNumber(value) - RationalNumber(error) && x <= RationalNumber(value) + RationalNumber(error);
}

}  // namespace

TEST_CASE("oriented cells: a turned frame errs by less than it says, and its boxes contain", "[methods][law]")
{
  property("coordinates of a turned frame", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    double const size = std::ldexp(1, random.between(-40, 40));
    auto const number = [&] { return random.chance(0.2) ? size : random.uniform(-size, size); };
    double const angle = random.uniform(0, 7);
    Turn const turn = random.chance(0.5) ? Turn::of_plan(std::cos(angle), std::sin(angle)) : random_rotation(random);
    for (auto f : frames) {
      f.turn = turn;
      Point3d const p{number(), number(), number()}, q = f(p);
      auto const truth = [&](double Point3d::*axis) {
        Point3d const row = turn.rows()[axis == &Point3d::x ? 0 : axis == &Point3d::y ? 1 : 2];
        return RationalNumber(row.x) * RationalNumber(p.x) + RationalNumber(row.y) * RationalNumber(p.y) +
               RationalNumber(row.z) * RationalNumber(p.z);
      };
      bool const keeps = turn.keeps_heights();
      RationalNumber const w = f.up ? truth(f.w) : -truth(f.w);
      RC_ASSERT(within(truth(f.u), q.x, f.u == axis_z && keeps ? 0 : f.error(p)));
      RC_ASSERT(within(truth(f.v), q.y, f.v == axis_z && keeps ? 0 : f.error(p)));
      RC_ASSERT(within(w, q.z, f.depth_error(p)));
      RC_ASSERT((f.depth_error(p) == 0) == (f.w == axis_z && keeps));
      Box const at = f.around(p);
      RC_ASSERT(RationalNumber(at.min.x) <= truth(f.u) && truth(f.u) <= RationalNumber(at.max.x));
      RC_ASSERT(RationalNumber(at.min.y) <= truth(f.v) && truth(f.v) <= RationalNumber(at.max.y));
      RC_ASSERT(RationalNumber(at.min.z) <= w && w <= RationalNumber(at.max.z));
      Box box{p, p};
      box.extend(Point3d{number(), number(), number()});
      Box const around = f(box);
      for (auto const& c : box.corners()) {
        Point3d const r = f(c);
        double const e = f.depth_error(c);
        RC_ASSERT(around.min.x <= r.x && r.x <= around.max.x && around.min.y <= r.y && r.y <= around.max.y);
        RC_ASSERT(around.min.z <= r.z && r.z <= around.max.z);
        RC_ASSERT(around.min.z <= r.z - e / 2 && r.z + e / 2 <= around.max.z);
      }
    }
  });
}

TEST_CASE("oriented cells: planes stand along a box in any position, tilted, long or thin", "[methods]")
{
  for (int trial = 0; trial < trials(200); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial) + 17);
    Box const box = any_cell_box(random);
    ViewCell const cell = ViewCell::hull(tilted_corners(random_rotation(random), box, random.point(-1000, 1000)));
    double const volume = 8 * box.max.x * box.max.y * box.max.z;
    for (auto const& f : frames_of(cell)) {
      REQUIRE(f.is_turned());
      CellViews const views(f, cell);
      CHECK(views.is_box);
      Point3d const size{views.bounds.max.x - views.bounds.min.x, views.bounds.max.y - views.bounds.min.y,
                         views.bounds.max.z - views.bounds.min.z};
      CHECK(size.x * size.y * size.z == Approx(volume).epsilon(1e-6));
      for (auto const& p : cell.vertices()) CHECK(contains(views.bounds, f(p)));
    }
  }
  // A slanting prism over a rectangle has 8 vertices, but is no box.
  CHECK(!frames_of(ViewCell::hull(
    std::vector<Point3d>{{0, 0, 0}, {4, 1, 1}, {3, 5, 0}, {-1, 4, -1}, {1, 0, 3}, {5, 1, 4}, {4, 5, 3}, {0, 4, 2}}))[0]
           .is_turned());
}

TEST_CASE("oriented cells: planes stand along an upright box in any position, otherwise along the axes", "[methods]")
{
  for (double const angle : {0.1, 0.5, 0.7853981633974483, 2.0, 4.0}) {
    Placement const place{angle, 100, -300};
    ViewCell const cell = placed_cell(place, street);
    auto const turned = frames_of(cell);
    for (auto const& f : turned) {
      REQUIRE(f.is_turned());
      CellViews const views(f, cell);
      CHECK(views.is_box);
      CHECK(views.vertices.size() == 8);
      Point3d const size{views.bounds.max.x - views.bounds.min.x, views.bounds.max.y - views.bounds.min.y,
                         views.bounds.max.z - views.bounds.min.z};
      CHECK(size.x * size.y * size.z == Approx(120 * 4 * 1.5).epsilon(1e-9));
      for (auto const& p : cell.vertices()) CHECK(contains(views.bounds, f(p)));
    }
  }
  CHECK(!frames_of(ViewCell(street))[0].is_turned());
  CHECK(!frames_of(
           ViewCell::hull(std::vector<Point3d>{{0, 0, 0}, {3, 1, 0}, {1, 3, 0}, {0, 0, 1}, {3, 1, 1}, {1, 3, 1}}))[0]
           .is_turned());
}

TEMPLATE_TEST_CASE("oriented cells: nothing of the exact set is missing", "[methods][conservative][law]",
                   ExtendedProjection, OcclusionSweep)
{
  std::size_t hidden = 0, exact_hidden = 0;
  for (int trial = 0; trial < trials(12); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial) + 911);
    Placement const place{random.uniform(0, 6.3), random.chance(0.3) ? random.uniform(-1e8, 1e8) : 0,
                          random.chance(0.3) ? random.uniform(-1e6, 1e6) : 0};
    Scene const scene = placed_town(place, random, 3);
    Box cell_box = street;
    if (random.chance(0.5))
      cell_box = {{random.uniform(-60, 0), 18, 0}, {random.uniform(1, 60), 22, random.uniform(1, 30)}};
    ViewCell const cell = placed_cell(place, cell_box);
    HeightField const field(scene);
    PreparedScene const prepared(scene);
    auto const exact = Exact25d<>()(field, cell).visible;
    Options options;
    options.resolution = 32 << random.below(5);
    if (random.chance(0.5)) options.distances = {random.uniform(1, 20), random.uniform(20, 60), random.uniform(60, 90)};
    options.improved = random.chance(0.7);
    options.directions = random.chance(0.8) ? Directions::cell : Directions::automatic;
    auto const set = TestType(options)(prepared, cell).visible;
    CAPTURE(exact.size(), set.size(), place.angle, options.resolution);
    REQUIRE(std::ranges::includes(set, exact));
    hidden += scene.objects.size() - set.size();
    exact_hidden += scene.objects.size() - exact.size();
  }
  CAPTURE(hidden, exact_hidden);
  CHECK(4 * hidden > exact_hidden);
}

TEMPLATE_TEST_CASE("oriented cells: a turned town is as well hidden as one along the axes", "[methods]",
                   ExtendedProjection, OcclusionSweep)
{
  std::size_t along = 0, turned = 0, along_axes = 0;
  for (double const angle : {0., 0.3, 0.785, 1.2}) {
    Random random(5);
    Placement const place{angle, 0, 0};
    Scene const scene = placed_town(place, random, 6);
    PreparedScene const prepared(scene);
    ViewCell const cell = placed_cell(place, street);
    Options options;
    options.directions = Directions::cell;
    auto const size = TestType(options)(prepared, cell).visible.size();
    (angle == 0 ? along : turned) += size;
    if (angle == 0) continue;
    Options axes;
    axes.directions = Directions::axes;
    along_axes += TestType(axes)(prepared, cell).visible.size();
  }
  CAPTURE(along, turned, along_axes);
  CHECK(10 * turned <= 11 * 3 * along);
  if (std::is_same_v<TestType, ExtendedProjection>) CHECK(turned < along_axes);  // docs/measurements.md
}

TEMPLATE_TEST_CASE("oriented cells: nothing of the exact set is missing from tilted cells over a town",
                   "[methods][conservative][law]", ExtendedProjection, OcclusionSweep)
{
  std::size_t hidden = 0, compared = 0;
  for (int trial = 0; trial < trials(12); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial) + 4711);
    Scene const scene = placed_town({random.uniform(0, 6.3), 0, 0}, random, 3);
    // Small tilts, which the ground hides, and any; the lowest corner is on the ground or above it.
    double const tilt = random.chance(0.5) ? random.uniform(-0.2, 0.2) : random.uniform(-1.5, 1.5),
                 angle = random.uniform(0, 6.3), c = std::cos(tilt), s = std::sin(tilt);
    auto corners =
      tilted_corners(Turn::of_plan(std::cos(angle), std::sin(angle)), {{-9, -2, -1}, {9, 2, 1}}, {0, 20, 0});
    for (auto& p : corners) p = {c * p.x - s * p.z, p.y, s * p.x + c * p.z};
    double lowest = HUGE_VAL;
    for (auto const& p : corners) lowest = std::min(lowest, p.z);
    double const up = random.chance(0.5) ? 0 : random.uniform(0, 3);
    for (auto& p : corners) p.z = p.z - lowest + up;
    ViewCell const cell = ViewCell::hull(corners);
    HeightField const field(scene);
    auto const exact = Exact25d<>()(field, cell);
    if (exact.guarantee != Guarantee::exact) continue;
    PreparedScene const prepared(scene);
    Options options;
    options.resolution = 64 << random.below(4);
    options.improved = random.chance(0.7);
    options.directions = Directions::cell;
    auto const set = TestType(options)(prepared, cell).visible;
    REQUIRE(std::ranges::includes(set, exact.visible));
    ++compared;
    hidden += scene.objects.size() - set.size();
  }
  CAPTURE(hidden, compared);
  CHECK(compared > 0);
  CHECK(hidden > 5 * compared);
}

TEMPLATE_TEST_CASE("oriented cells: the hunt finds nothing missing from tilted cells", "[methods][conservative]",
                   ExtendedProjection, OcclusionSweep)
{
  std::size_t hidden = 0, objects = 0;
  for (int trial = 0; trial < trials(10); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial) + 99);
    Turn const turn = random_rotation(random);
    double const far = random.chance(0.3) ? 1e6 : 10;
    Point3d const move = random.point(-far, far);
    Scene const scene = tilted_walls(turn, move, random);
    PreparedScene const prepared(scene);
    // Along the walls, or across them.
    ViewCell const cell =
      ViewCell::hull(tilted_corners(random.chance(0.5) ? turn : random_rotation(random), any_cell_box(random), move));
    Options options;
    options.directions = Directions::cell;
    options.resolution = 32 << random.below(4);
    options.improved = random.chance(0.7);
    if (random.chance(0.3)) options.distances = {random.uniform(1, 30), random.uniform(30, 60), random.uniform(60, 90)};
    auto const set = TestType(options)(prepared, cell).visible;
    auto const report = check(prepared, cell, set, Guarantee::conservative, {.rays = 20'000, .threads = 1});
    REQUIRE(report.missing.empty());
    hidden += scene.objects.size() - set.size();
    objects += scene.objects.size();
  }
  CAPTURE(hidden, objects);
  CHECK(3 * hidden > objects);
}

TEMPLATE_TEST_CASE("oriented cells: tilted walls are as well hidden as walls along the axes", "[methods]",
                   ExtendedProjection, OcclusionSweep)
{
  Box const box{{-24, -2, -1}, {24, 2, 1}};
  Options options;
  options.directions = Directions::cell;
  auto const visible = [&](Turn const& turn, Options const& o) {
    Random random(3);
    Scene const scene = tilted_walls(turn, {5, 6, 7}, random);
    PreparedScene const prepared(scene);
    return TestType(o)(prepared, ViewCell::hull(tilted_corners(turn, box, {5, 6, 7}))).visible.size();
  };
  std::size_t const along = visible(Turn(), options);
  CHECK(along < 45);
  Options axes;
  axes.directions = Directions::axes;
  std::size_t all = 0, all_by_axes = 0;
  for (int trial = 0; trial < 4; ++trial) {
    Random random(static_cast<std::uint64_t>(trial) + 5);
    Turn const turn = random_rotation(random);
    auto const tilted = visible(turn, options);
    CAPTURE(along, tilted);
    CHECK(10 * tilted <= 12 * along);
    all += tilted;
    all_by_axes += visible(turn, axes);
  }
  CAPTURE(all, all_by_axes);
  CHECK(all < all_by_axes);
}
