#include "support/catch.hpp"
#include "support/random_scenes.hpp"

#include "visibility/methods/strong_occlusion/survey.hpp"
#include "visibility/scene/generators.hpp"

using namespace visibility;
using namespace visibility::test;
using strong_occlusion::Options;
using strong_occlusion::survey;

TEST_CASE("survey: smaller cells see fewer boxes and polygons of the paper's city", "[methods]")
{
  Scene const scene = generate("city");
  PreparedScene const prepared(scene);
  REQUIRE(scene.boxes.size() == 3324);
  std::uint64_t hidden = 0, piecewise = 0, polygons = ~std::uint64_t{0};
  for (double const side : {200., 150., 100., 90., 80., 70., 60., 50., 40., 30., 20., 10.}) {
    CAPTURE(side);
    double const h = side / 2;
    auto const s = survey<Filtered>(prepared, ViewCell(Box{{-h, -h, 0}, {h, h, 50}}), {});
    REQUIRE(s.bodies == 3324);
    REQUIRE(s.hidden_bodies >= hidden);
    REQUIRE(s.hidden_piecewise >= std::max(piecewise, s.hidden_bodies));
    REQUIRE(s.visible_polygons <= polygons);
    hidden = s.hidden_bodies;
    piecewise = s.hidden_piecewise;
    polygons = s.visible_polygons;
  }
  // 3116 in table 1 of [CohenOr98]: most of what is hidden at all has a strong occluder.
  REQUIRE(hidden > 3000);
}

TEST_CASE("survey: counts what the method hides, whatever the optimizations", "[methods][law]")
{
  auto const seed = GENERATE(range(1, 31));
  CAPTURE(seed);
  Random random(static_cast<std::uint64_t>(seed));
  ViewCell const cell(grid_box(random, -2, 2));
  Scene const scene = grid_scene(random, random.between(2, 40), -12, 12, Mix::all);
  PreparedScene const prepared(scene);
  auto const all = survey<Filtered>(prepared, cell, {});
  auto const none = survey<Filtered>(prepared, cell, Options::naive(Options{}.granularity));
  REQUIRE(all.bodies == prepared.bodies().bodies().size());
  REQUIRE(all.hidden_bodies == none.hidden_bodies);
  REQUIRE(all.hidden_piecewise == none.hidden_piecewise);
  REQUIRE(all.visible_polygons == none.visible_polygons);
  REQUIRE(all.counts.rays <= none.counts.rays);
}

TEST_CASE("survey: a body around the cell is not hidden, though none of its faces looks at the cell",
          "[methods][regression]")
{
  SceneBuilder builder("test");
  builder.begin_object("around");
  builder.add(Box{{-9, -9, -9}, {9, 9, 9}});
  Scene const scene = builder.finish();
  auto const s = survey<Filtered>(PreparedScene(scene), ViewCell(Box{{0, 0, 0}, {1, 1, 1}}), {});
  REQUIRE(s.hidden_bodies == 0);
  REQUIRE(s.hidden_piecewise == 0);
}
