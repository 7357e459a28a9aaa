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
    for (auto f : frames) {
      f.a = std::cos(angle), f.b = std::sin(angle);
      Point3d const p{number(), number(), number()}, q = f(p);
      RationalNumber const a(f.a), b(f.b), x(p.x), y(p.y);
      RationalNumber const truth[] = {a * x + b * y, a * y - b * x, RationalNumber(p.z)};
      auto const of = [&](double Point3d::*axis) {
        return truth[axis == &Point3d::x ? 0 : axis == &Point3d::y ? 1 : 2];
      };
      RC_ASSERT(within(of(f.u), q.x, f.u == axis_z ? 0 : f.error(p)));
      RC_ASSERT(within(of(f.v), q.y, f.v == axis_z ? 0 : f.error(p)));
      RC_ASSERT(within(f.up ? of(f.w) : -of(f.w), q.z, f.w == axis_z ? 0 : f.error(p)));
      Box box{p, p};
      box.extend(Point3d{number(), number(), number()});
      Box const around = f(box);
      for (auto const& c : box.corners()) {
        Point3d const r = f(c);
        double const e = f.error(c);
        RC_ASSERT(around.min.x <= r.x && r.x <= around.max.x && around.min.y <= r.y && r.y <= around.max.y);
        RC_ASSERT(around.min.z <= r.z && r.z <= around.max.z);
        if (f.w != axis_z) RC_ASSERT(around.min.z <= r.z - e / 2 && r.z + e / 2 <= around.max.z);
      }
    }
  });
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
