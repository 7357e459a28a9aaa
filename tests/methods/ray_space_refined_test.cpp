#include "support/box_scene.hpp"
#include "support/catch.hpp"
#include "support/height_field_scenes.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/methods/ray_space/method.hpp"
#include "visibility/methods/ray_space/occludee.hpp"
#include "visibility/methods/ray_space/occluder.hpp"
#include "visibility/methods/ray_space/refined_map.hpp"

#include <algorithm>
#include <cmath>

using namespace visibility;
using namespace visibility::test;
using namespace visibility::ray_space;

// Parts of pixels.
namespace {

Box const cell{{-1, -1, 0}, {1, 1, 2}};

/// One family of directions, with bodies entered by hand.
struct Family {
  explicit Family(Options const& options)
    : frame(cell, 0, options.first_resolution(), options.first_resolution() / 8), map(frame, options.components),
      refined(frame, map, options), writer(0, options), test({{&frame, &map, &refined}})
  {
  }
  void enter(Box const& box)
  {
    Chords chords;
    chords_of(box, chords);
    writer.write(chords, box, frame, map, &refined);
  }

  Frame frame;
  OcclusionMap map;
  RefinedMap refined;
  OccluderWriter writer;
  OccludeeTest test;
};

/// Two walls in one line, `gap` between them from y = `at` on.
std::vector<Box> walls(double at, double gap) { return {{{5, -40, 0}, {6, at, 30}}, {{5, at + gap, 0}, {6, 40, 30}}}; }

}  // namespace

TEST_CASE("ray-space: walls that overlap within a pixel hide together what neither hides there", "[methods]")
{
  // A box behind two walls, one of which begins where the other ends and a little before: no pixel of the coarse map
  // that their ends cross is covered by either.
  std::vector<Box> const scene{{{5, -40, 0}, {6, 0.13, 30}}, {{6, 0.1, 0}, {7, 40, 30}}, {{20, -2, 0}, {21, 2, 5}}};
  Scene const all = box_scene(scene);
  PreparedScene const prepared(all);
  auto const seen = [&](Options const& o) { return RaySpace(o)(prepared, ViewCell(cell)).visible; };
  using Set = std::vector<std::uint32_t>;
  CHECK(seen({.resolution = 64, .coarse = 64}) == Set{0, 1, 2});
  for (int const coarse : {16, 64, 512}) CHECK(seen({.resolution = 4096, .coarse = coarse}) == Set{0, 1});
}

TEST_CASE("ray-space: what is seen through a gap is visible however far pixels are divided", "[methods][conservative]")
{
  for (int trial = 0; trial < trials(40); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial));
    auto scene = walls(random.uniform(-1, 1), std::ldexp(1.0, -random.between(1, 50)));
    scene.push_back({{20, -2, 0}, {21, 2, 5}});
    Scene const all = box_scene(scene);
    Options const options{.resolution = 1 << random.between(5, 16), .coarse = 1 << random.between(4, 9)};
    CAPTURE(options.resolution, options.coarse);
    CHECK(RaySpace(options)(PreparedScene(all), ViewCell(cell)).visible.size() == 3);
  }
}

TEST_CASE("ray-space: halves of a part cover its lines, down to the resolution", "[methods][law]")
{
  Family family({.resolution = 256, .coarse = 32});
  Random random(1);
  for (int trial = 0; trial < trials(200); ++trial) {
    CAPTURE(trial);
    int const row = random.below(32), column = random.below(4);
    auto part = family.refined.part(row, column);
    Pixel const whole = family.refined[part].pixel();
    double smallest_s = whole.s1 - whole.s0, smallest_t = whole.t1 - whole.t0;
    while (auto const first = family.refined.halves(part, random.uniform(0, 100))) {
      Pixel const p = family.refined[part].pixel(), a = family.refined[*first].pixel(),
                  b = family.refined[*first + 1].pixel();
      bool const in_t = a.s0 == b.s0 && a.s1 == b.s1;
      CHECK(a.s0 == p.s0);
      CHECK(a.t0 == p.t0);
      CHECK(b.s1 == p.s1);
      CHECK(b.t1 == p.t1);
      CHECK((in_t ? a.t1 == b.t0 && a.t0 < a.t1 && b.t0 < b.t1 : a.s1 == b.s0 && a.s0 < a.s1 && b.s0 < b.s1));
      CHECK((in_t || (a.t0 == b.t0 && a.t1 == b.t1)));
      part = *first + static_cast<std::uint32_t>(random.below(2));
      Pixel const& half = family.refined[part].pixel();
      smallest_s = half.s1 - half.s0, smallest_t = half.t1 - half.t0;
    }
    // Lines of a raster are rounded one by one.
    CHECK(smallest_s == Approx((whole.s1 - whole.s0) / 8));
    CHECK(smallest_t == Approx((whole.t1 - whole.t0) / 8));
  }
}

TEST_CASE("ray-space: what the parts of a pixel have in common the pixel keeps", "[methods]")
{
  Family family({.resolution = 4096, .coarse = 64, .components = 1});
  for (auto const& wall : {Box{{5, -40, 0}, {6, 0.13, 30}}, Box{{6, 0.1, 0}, {7, 40, 30}}}) family.enter(wall);
  // The parts that something wide is asked of fill the pixels of something narrow.
  Box const narrow{{20, -1, 0}, {21, 1, 5}}, wide{{20, -8, 0}, {21, 8, 5}};
  using Pixels = OccludeeTest::Pixels;
  CHECK_FALSE(family.test.hidden(narrow, Pixels::whole));
  CHECK(family.test.hidden(wide));
  CHECK(family.test.hidden(narrow, Pixels::whole));
}

TEST_CASE("ray-space: bodies that come later serve parts that were made before", "[methods]")
{
  Family family({.resolution = 4096, .coarse = 16});
  Box const target{{20, -2, 0}, {21, 2, 5}};
  family.enter({{5, -40, 0}, {6, 0.13, 30}});
  CHECK_FALSE(family.test.hidden(target));
  family.enter({{6, 0.1, 0}, {7, 40, 30}});
  CHECK(family.test.hidden(target));
}

TEST_CASE("ray-space: finer pixels hide more", "[methods]")
{
  std::size_t kept[3] = {0, 0, 0};
  for (int trial = 0; trial < trials(30); ++trial) {
    Random random(static_cast<std::uint64_t>(trial));
    auto const c = height_case(random, height_scenes[0], 40);
    PreparedScene const prepared(c.scene);
    ViewCell const of = ViewCell::hull(c.cell);
    kept[0] += RaySpace({.resolution = 32, .coarse = 32})(prepared, of).visible.size();
    kept[1] += RaySpace({.resolution = 256, .coarse = 32})(prepared, of).visible.size();
    kept[2] += RaySpace({.resolution = 4096, .coarse = 32})(prepared, of).visible.size();
  }
  CAPTURE(kept[0], kept[1], kept[2]);
  CHECK(kept[0] > kept[1]);
  CHECK(kept[1] > kept[2]);
}
