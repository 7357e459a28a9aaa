#include "support/catch.hpp"
#include "support/height_field_scenes.hpp"
#include "support/random_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/evidence/check.hpp"
#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/scene/generators.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using extended_projection::Options;

namespace {

/// Options at random: any resolution, planes chosen or anywhere.
Options any_options(Random& random, double scale)
{
  Options o;
  o.resolution = 16 << random.below(6);
  if (random.chance(0.1)) o.resolution = random.between(1, 40);
  if (random.chance(0.02)) o.resolution = 1024 << random.below(2);
  o.extent = random.chance(0.5) ? 1.5 : random.uniform(0.1, 4);
  o.planes = random.between(1, 5);
  o.kernel = random.uniform(1.5, 9);
  o.infinity = random.chance(0.2);
  if (random.chance(0.5))
    o.directions = random.chance(0.7) ? extended_projection::Directions::cell : extended_projection::Directions::axes;
  if (random.chance(0.4)) o.reprojection = extended_projection::Reprojection::convolution;
  o.occluders = random.chance(0.3) ? static_cast<std::size_t>(random.between(0, 6)) : 2000;
  o.more_occluders = random.chance(0.5);
  o.improved = random.chance(0.7);
  if (random.chance(0.5)) o.depth = extended_projection::PartDepth::pixel;
  if (random.chance(0.6))
    for (int i = random.between(1, 5); i > 0; --i)
      o.distances.push_back(scale * (random.chance(0.5) ? random.between(1, 8) : random.uniform(0.01, 9)));
  return o;
}

std::vector<std::uint32_t> missing(std::vector<std::uint32_t> const& exact, std::vector<std::uint32_t> const& set)
{
  std::vector<std::uint32_t> out;
  std::ranges::set_difference(exact, set, std::back_inserter(out));
  return out;
}

}  // namespace

TEMPLATE_TEST_CASE("extended projections: nothing of the exact set is missing", "[methods][conservative][law]",
                   ExtendedProjection, OcclusionSweep)
{
  std::size_t exact_hidden = 0, hidden = 0;
  for (auto const kind : height_scenes)
    for (int trial = 0; trial < trials(15); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(7000 * int(kind) + trial));
      auto const c = height_case(random, kind, random.between(3, 14));
      HeightField const field(c.scene);
      ViewCell const cell = ViewCell::hull(c.cell);
      auto const exact = Exact25d<>()(field, cell);
      if (exact.guarantee != Guarantee::exact) continue;
      PreparedScene const scene(c.scene);
      double const scale = kind == HeightScene::far_detail ? 0.001 : 1;
      for (int k = 0; k < 4; ++k) {
        auto const options = k == 0 ? Options{} : any_options(random, scale);
        CAPTURE(k, options.resolution, options.distances, options.improved);
        auto const set = TestType(options)(scene, cell);
        REQUIRE(missing(exact.visible, set.visible).empty());
        if (k > 0) continue;
        hidden += c.scene.objects.size() - set.visible.size();
        exact_hidden += c.scene.objects.size() - exact.visible.size();
      }
    }
  CAPTURE(hidden, exact_hidden);
  CHECK(4 * hidden > exact_hidden);  // not everything is called visible
}

TEMPLATE_TEST_CASE("extended projections: the hunt finds nothing missing in random solid scenes",
                   "[methods][conservative]", ExtendedProjection, OcclusionSweep)
{
  for (int trial = 0; trial < trials(15); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial) + 31);
    Box const clear{{-1, -1, -1}, {1, 1, 1}};
    Scene const scene = grid_scene(random, random.between(5, 60), -6, 6, Mix::all, clear);
    PreparedScene const prepared(scene);
    ViewCell const cell(clear);
    auto const set = TestType(any_options(random, 1))(prepared, cell);
    auto const report = check(prepared, cell, set.visible, Guarantee::conservative, {.rays = 20'000, .threads = 1});
    REQUIRE(report.missing.empty());
  }
}

TEMPLATE_TEST_CASE("extended projections: the hunt finds nothing missing in the scenes of the papers",
                   "[methods][conservative]", ExtendedProjection, OcclusionSweep)
{
  struct Case {
    char const* scene;
    Box cell;
  };
  for (auto const& c :
       {Case{"box-field,n=2000", {{-5, -5, 5}, {5, 5, 10}}},
        Case{"forest,n=60,leaves=300,leaf=0.6", {{-0.1, -0.1, 5}, {0.1, 0.1, 5.2}}},
        Case{"urban,n=200", {{-10, -10, 0}, {10, 10, 2.5}}}, Case{"district", {{-5, 10, 0}, {5, 60, 3}}}}) {
    CAPTURE(c.scene);
    Scene const scene = generate(c.scene);
    PreparedScene const prepared(scene);
    ViewCell const cell(c.cell);
    Random random(5);
    for (int k = 0; k < 2; ++k) {
      auto options = k == 0 ? Options{} : any_options(random, 5);
      auto const set = TestType(options)(prepared, cell);
      CAPTURE(set.visible.size(), scene.objects.size(), options.resolution, options.distances);
      auto const report = check(prepared, cell, set.visible, Guarantee::conservative,
                                {.rays = static_cast<std::uint64_t>(trials(300'000)), .threads = 1});
      REQUIRE(report.missing.empty());
    }
  }
}
