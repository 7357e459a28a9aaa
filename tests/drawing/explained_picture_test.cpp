#include "support/catch.hpp"

#include "visibility/drawing/explained_picture.hpp"
#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <cmath>

using namespace visibility;

namespace {

Scene street()
{
  SceneBuilder builder("test");
  builder.begin_object("wall");
  builder.add(Box{{10, -5, 0}, {11, 5, 1}});
  builder.begin_object("tower");
  builder.add(Box{{20, -2, 0}, {22, 2, 30}});
  return builder.finish();
}

}  // namespace

TEST_CASE("explained picture: the parts of edges, funnels and shadows that were asked for", "[drawing]")
{
  Scene const scene = street();
  HeightField const field(scene);
  ViewCell const cell(Box{{-1, -1, 0}, {1, 1, 4}});
  auto const explanation = Exact25d<>().explain(field, cell).second;
  PlanRegion const region{{-5, -20}, {45, 20}};
  auto picture = plan_picture(cell, region);
  add_explanation(picture, explanation, {});
  REQUIRE((picture.funnels.empty() && picture.shadows.empty()));
  // The front edges of both, whole: nothing higher stands before them.
  auto const drawn = [&](Point2d const& a, Point2d const& b) {
    return std::ranges::any_of(picture.edge_parts, [&](auto const& e) {
      return (e.at.from == a && e.at.to == b) || (e.at.from == b && e.at.to == a);
    });
  };
  REQUIRE(drawn({10, -5}, {10, 5}));
  REQUIRE(drawn({20, -2}, {20, 2}));

  auto detailed = plan_picture(cell, region);
  add_explanation(detailed, explanation, {.funnels = 2, .shadows = 1000, .ground = 0});
  REQUIRE(detailed.funnels.size() == std::min<std::size_t>(2, explanation.cells.size()));
  REQUIRE(detailed.shadows.size() == 2 * explanation.shadows.size());
  REQUIRE(!detailed.shadows.empty());
  for (auto const& s : detailed.shadows)
    for (auto const& p : s) REQUIRE(is_finite(p));
  for (auto const& f : detailed.funnels)
    for (auto const& p : f.area) REQUIRE(is_finite(p));
}

TEST_CASE("explained picture: a shadow ends where the plane through source and edge meets the ground", "[drawing]")
{
  ViewCell const cell(Box{{-1, -1, 0}, {1, 1, 4}});
  exact_25d::Explanation explanation;
  explanation.shadows.push_back({{{1, 1, 4}, {1, -1, 4}}, {{10, 5, 1}, {10, -5, 1}}});
  auto picture = plan_picture(cell, {{-5, -20}, {45, 20}});
  add_explanation(picture, explanation, {.shadows = 1, .ground = 0});
  REQUIRE(picture.shadows.size() == 2);
  // From (1, 1, 4) over (10, 5, 1) the ground is met a third of the way further: three down, then one.
  REQUIRE(picture.shadows[0][0] == Point2d{10, 5});
  REQUIRE(picture.shadows[0][3].x == Approx(13));
  REQUIRE(picture.shadows[0][3].y == Approx(5 + 4 / 3.0));
  // Nothing ends the shadow of an edge as high as the eye within the picture.
  explanation.shadows[0].occluder = {{10, 5, 4}, {10, -5, 4}};
  auto endless = plan_picture(cell, {{-5, -20}, {45, 20}});
  add_explanation(endless, explanation, {.shadows = 1, .ground = 0});
  REQUIRE(endless.shadows[0][3].x > 45);
}
