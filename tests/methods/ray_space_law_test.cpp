#include "support/catch.hpp"
#include "support/random_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/evidence/check.hpp"
#include "visibility/methods/ray_space/method.hpp"
#include "visibility/methods/ray_space/occludee.hpp"
#include "visibility/methods/ray_space/occluder.hpp"
#include "visibility/scene/generators.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::ray_space;

namespace {

/// All bodies of a scene in the maps of a cell, in any order, whether visible or not.
struct World {
  World(PreparedScene const& scene, Box const& cell, double floor, Random& random)
    : options{.resolution = 1 << random.between(4, 9), .components = random.between(1, 4)}, writer(floor, options)
  {
    for (int f = 0; f < 4; ++f) frames.emplace_back(cell, f, options.resolution, options.resolution / 4);
    for (auto const& f : frames) maps.emplace_back(f, options.components);
    auto const& bodies = scene.bodies().bodies();
    std::vector<std::size_t> order(bodies.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i, std::swap(order[i], order[static_cast<std::size_t>(random.between(0, static_cast<int>(i)))]);
    Chords chords;
    for (auto const i : order) {
      if (!bodies[i].occludes) continue;
      visit_shape(scene.bodies(), bodies[i], [&](auto const& shape) { chords_of(shape, chords); });
      for (std::size_t f = 0; f < 4; ++f)
        pixels += writer.write(chords, scene.bodies().bounds()[i], frames[f], maps[f]);
    }
  }

  OccludeeTest test() const
  {
    std::vector<OccludeeTest::Family> families;
    for (std::size_t f = 0; f < 4; ++f) families.push_back({&frames[f], &maps[f]});
    return OccludeeTest(families);
  }

  Options options;
  OccluderWriter writer;
  std::vector<Frame> frames;
  std::vector<OcclusionMap> maps;
  std::size_t pixels = 0;
};

Box small_box(Random& random, int lo, int hi)
{
  for (;;) {
    Point3d const p = random.grid_point(lo, hi);
    Box const b{p, {p.x + random.uniform(0, 1), p.y + random.uniform(0, 1), p.z + random.uniform(0, 1)}};
    if (b.max.z <= hi) return b;
  }
}

bool blocked(ConvexBodies const& bodies, Point3d const& p, Point3d const& q)
{
  return std::ranges::any_of(bodies.bodies(), [&](auto const& b) {
    return b.occludes && segment_meets<Filtered, End::excluded>(bodies, b, p, q);
  });
}

Scene shifted(Scene s, Point3d const& by)
{
  auto const move = [&](Point3d& p) { p = {p.x + by.x, p.y + by.y, p.z + by.z}; };
  for (auto& b : s.boxes) move(b.min), move(b.max);
  for (auto& b : s.balls) move(b.centre);
  for (auto& v : s.vertices) move(v);
  for (auto& p : s.polyhedra)
    for (auto& v : p.vertices) move(v);
  for (auto& p : s.prisms) {
    for (auto& ring : p.rings)
      for (auto& v : ring) v = {v.x + by.x, v.y + by.y};
    p.bottom += by.z, p.top += by.z;
  }
  return s;
}

}  // namespace

TEST_CASE("ray-space: every sight line to what is called hidden is blocked", "[methods][conservative]")
{
  int hidden = 0;
  std::size_t pixels = 0;
  for (int trial = 0; trial < trials(100); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    Box cell = grid_box(random, -2, 2);
    bool const far = random.chance(0.3);
    Scene scene = grid_scene(random, random.between(5, 40), -8, 8, random.chance(0.5) ? Mix::all : Mix::boxes, cell);
    Point3d const by = far ? Point3d{1e6, -2e6, 300} : Point3d{0, 0, 0};
    scene = shifted(std::move(scene), by);
    auto const at = [&](Point3d const& p) { return Point3d{p.x + by.x, p.y + by.y, p.z + by.z}; };
    cell = {at(cell.min), at(cell.max)};
    PreparedScene const prepared(scene);
    World const world(prepared, cell, at({0, 0, -8}).z, random);
    pixels += world.pixels;
    OccludeeTest test = world.test();
    for (int i = 0; i < 20; ++i) {
      Box box = small_box(random, -8, 8);
      box = {at(box.min), at(box.max)};
      auto const corners = box.corners();
      std::array<Point3d, 3> const triangle{corners[0], corners[3], corners[6]};
      bool const whole = random.chance(0.5);
      if (whole ? !test.hidden(box) : !test.hidden(box, triangle)) continue;
      ++hidden;
      for (int k = 0; k < 40; ++k) {
        Point3d const p{random.uniform(cell.min.x, cell.max.x), random.uniform(cell.min.y, cell.max.y),
                        random.uniform(cell.min.z, cell.max.z)};
        Point3d const from = random.chance(0.5) ? cell.corner(random.below(8)) : p;
        auto const pick = static_cast<std::size_t>(random.below(whole ? 8 : 3));
        Point3d const q = whole ? corners[pick] : triangle[pick];
        if (from != q) CHECK(blocked(prepared.bodies(), from, q));
      }
    }
  }
  CAPTURE(hidden, pixels);
  CHECK(hidden > trials(30));
}

TEST_CASE("ray-space: guided rays find nothing that is missing", "[methods][conservative]")
{
  std::size_t hidden = 0;
  for (int trial = 0; trial < trials(25); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    Options options{.resolution = 1 << random.between(5, 9), .components = random.between(1, 4)};
    options.umbra = random.chance(0.3) ? Umbra::half : Umbra::full;
    options.bounds = random.chance(0.5) ? Bounds::exact : Bounds::linear;
    options.granularity = static_cast<Granularity>(random.below(4));
    bool const field = random.chance(0.4);
    Box box = field ? Box{{-9, -9, 0}, {9, 9, 10}} : grid_box(random, -4, 4);
    Scene const scene =
      field ? generate("box-field,n=300,density=0.4,clear=10,height=18,seed=" + std::to_string(trial + 1))
            : grid_scene(random, random.between(20, 150), -10, 10, trial % 2 == 0 ? Mix::all : Mix::boxes, box);
    PreparedScene const prepared(scene);
    ViewCell cell(box);
    if (random.chance(0.3)) {
      auto const c = box.corners();
      cell = ViewCell::hull(std::vector<Point3d>{c[0], c[1], c[2], c[4], c[7]});
    }
    auto const set = RaySpace(options)(prepared, cell);
    hidden += scene.objects.size() - set.visible.size();
    CheckOptions hunt;
    hunt.rays = 20'000;
    hunt.threads = 1;
    auto const report = check(prepared, cell, set.visible, set.guarantee, hunt);
    CHECK(report.missing == std::vector<std::uint32_t>{});
  }
  CAPTURE(hidden);
  CHECK(hidden > 0);
}
