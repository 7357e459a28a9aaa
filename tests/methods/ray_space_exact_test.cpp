#include "support/catch.hpp"
#include "support/height_field_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/ray_space/method.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;

namespace {

constexpr int resolutions[] = {32, 64, 128, 256, 512, 1024, 2048};

/// Mostly coarse maps, which are fast and where rounding to pixels has most to get wrong.
ray_space::Options any_options(Random& random)
{
  ray_space::Options o;
  o.resolution = resolutions[random.chance(0.9) ? random.below(4) : random.below(7)];
  o.coarse = resolutions[random.below(random.chance(0.9) ? 4 : 7)];
  o.components = random.chance(0.8) ? random.between(1, 5) : random.between(6, ray_space::Options::max_components);
  o.umbra = random.chance(0.5) ? ray_space::Umbra::half : ray_space::Umbra::full;
  o.bounds = random.chance(0.5) ? ray_space::Bounds::exact : ray_space::Bounds::linear;
  o.granularity = static_cast<ray_space::Granularity>(random.below(4));
  return o;
}

/// What a field of the world looks like `by` metres further off, as far as doubles can tell.
Scene moved(Scene scene, double by)
{
  for (auto& b : scene.boxes) b = {{b.min.x + by, b.min.y - by, b.min.z}, {b.max.x + by, b.max.y - by, b.max.z}};
  for (auto& v : scene.vertices) v = {v.x + by, v.y - by, v.z};
  return scene;
}

}  // namespace

TEST_CASE("ray-space: nothing that the exact set holds is missing", "[methods][conservative]")
{
  int visible = 0, kept = 0, hidden = 0;
  for (auto const kind : height_scenes)
    for (int trial = 0; trial < trials(60); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(100'000 * int(kind) + trial));
      auto c = height_case(random, kind, random.between(3, 25));
      if (random.chance(0.25)) {
        c.scene = moved(std::move(c.scene), 1e6);
        for (auto& p : c.cell) p = {p.x + 1e6, p.y - 1e6, p.z};
      }
      ViewCell const cell = ViewCell::hull(c.cell);
      auto const exact = Exact25d<Filtered>()(HeightField(c.scene), cell);
      if (exact.guarantee != Guarantee::exact) continue;
      auto const options = any_options(random);
      CAPTURE(options.resolution, options.coarse, options.components, to_string(options.umbra),
              to_string(options.bounds));
      auto const set = RaySpace(options)(PreparedScene(c.scene), cell);
      REQUIRE(set.guarantee == Guarantee::conservative);
      std::vector<std::uint32_t> missing;
      std::ranges::set_difference(exact.visible, set.visible, std::back_inserter(missing));
      CHECK(missing == std::vector<std::uint32_t>{});
      visible += static_cast<int>(exact.visible.size());
      kept += static_cast<int>(set.visible.size());
      hidden += static_cast<int>(c.scene.objects.size() - set.visible.size());
    }
  CAPTURE(visible, kept, hidden);
  CHECK(hidden > 0);
}
