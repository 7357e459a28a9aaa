#include "support/box_scene.hpp"
#include "support/catch.hpp"
#include "support/height_field_occludees.hpp"
#include "support/trials.hpp"

#include "visibility/methods/exact_25d/method.hpp"

#include <numeric>

using namespace visibility;
using namespace visibility::test;
using exact_25d::Options;

namespace {

using Indices = std::vector<std::uint32_t>;

/// What hides, and what is looked for.
struct Both {
  Both(Scene const& occluders, Scene const& targets) : field(occluders), prepared(targets), occludees(prepared) {}
  HeightField field;
  PreparedScene prepared;
  Occludees occludees;
};

template <Arithmetic A = Filtered>
Indices visible(Both const& both, ViewCell const& cell, Options const& options = {})
{
  return Exact25d<A>(options)(both.field, both.occludees, cell).visible;
}

bool has_area(Point3d const& a, Point3d const& b, Point3d const& c)
{
  auto const turns = [&](auto const& u, auto const& v) {
    return !is_zero(orient2d<Filtered>(Point2d{u(a), v(a)}, Point2d{u(b), v(b)}, Point2d{u(c), v(c)}));
  };
  auto const x = [](Point3d const& p) { return p.x; };
  auto const y = [](Point3d const& p) { return p.y; };
  auto const z = [](Point3d const& p) { return p.z; };
  return turns(x, y) || turns(y, z) || turns(z, x);
}

/// Without triangles that have no area: they could meet the cell, but the oracle does not count them.
Scene scene_of(std::vector<oracle::Occludee> const& occludees)
{
  SceneBuilder builder("occludees");
  for (std::size_t o = 0; o < occludees.size(); ++o) {
    builder.begin_object("occludee " + std::to_string(o));
    for (auto const& polygon : occludees[o].polygons) {
      std::vector<std::uint32_t> v;
      for (auto const& p : polygon) v.push_back(builder.add_vertex(p));
      for (std::size_t i = 2; i < v.size(); ++i)
        if (has_area(polygon[0], polygon[i - 1], polygon[i])) builder.add_triangle(v[0], v[i - 1], v[i]);
    }
  }
  return builder.finish();
}

/// Occludees without area are no objects of the scene.
std::size_t index_of(Object const& object) { return std::stoul(object.name.substr(object.name.rfind(' '))); }

/// Calls law(case, occludees) with random ones; those where a column reaches the cell's top are left out.
template <class Law>
void for_cases(int base, Law const& law)
{
  for (auto const kind : height_scenes)
    for (int trial = 0; trial < trials(base); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(90000 + 1000 * int(kind) + trial));
      auto const c = height_case(random, kind, random.between(1, 10));
      auto const columns = oracle_columns(HeightField(c.scene));
      law(c, random_occludees(kind, random, columns, oracle_cell(c.cell), 5), random);
    }
}

Box box(double x0, double y0, double z0, double x1, double y1, double z1) { return {{x0, y0, z0}, {x1, y1, z1}}; }

}  // namespace

TEST_CASE("exact-2.5d: objects are seen alike as occluders and as occludees", "[methods][law]")
{
  int compared = 0;
  for_cases(40, [&](HeightCase const& c, auto const&, Random&) {
    Both const both(c.scene, c.scene);
    auto const cell = ViewCell::hull(c.cell);
    auto const expected = Exact25d<Filtered>()(both.field, cell);
    if (expected.guarantee != Guarantee::exact) return;
    ++compared;
    CHECK(visible(both, cell) == expected.visible);
  });
  CHECK(compared > trials(100));
}

TEST_CASE("exact-2.5d: objects are seen alike from a cell that is no upright prism", "[methods][law]")
{
  int compared = 0;
  for (auto const kind : {HeightScene::general, HeightScene::slanted, HeightScene::streets})
    for (int trial = 0; trial < trials(25); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(99000 + 1000 * int(kind) + trial));
      auto const c = height_case(random, kind, random.between(3, 14));
      std::vector<Point3d> corners;
      for (int i = random.between(5, 9); i > 0; --i)
        corners.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.5, 3)});
      auto const cell = ViewCell::hull(corners);
      Both const both(c.scene, c.scene);
      auto const expected = Exact25d<Filtered>()(both.field, cell);
      if (expected.guarantee != Guarantee::exact) continue;
      ++compared;
      CHECK(visible(both, cell) == expected.visible);
      CHECK(visible<Rational>(both, cell) == expected.visible);
    }
  CHECK(compared > trials(20));
}

TEST_CASE("exact-2.5d: the visible occludees are those of the brute-force oracle", "[methods][oracle]")
{
  int undecided = 0, seen = 0, hidden = 0;
  for_cases(40, [&](HeightCase const& c, std::vector<oracle::Occludee> const& occludees, Random&) {
    Scene const targets = scene_of(occludees);
    Both const both(c.scene, targets);
    auto const columns = oracle_columns(both.field);
    oracle::Answer answer;
    try {
      answer = oracle::visible_occludees(columns, occludees, oracle_cell(c.cell));
    } catch (std::invalid_argument const&) {
      return;  // a column reaches the cell's top
    }
    Options options;
    options.witnesses = true;
    auto const set = Exact25d<Filtered>(options)(both.field, both.occludees, ViewCell::hull(c.cell));
    if (set.guarantee != Guarantee::exact) return;
    for (auto const& w : set.witnesses)
      CHECK(oracle::confirms(columns, occludees[index_of(targets.objects[w.object])], oracle_cell(c.cell), w));
    for (std::uint32_t o = 0; o < targets.objects.size(); ++o) {
      CAPTURE(targets.objects[o].name);
      bool const is_visible = std::ranges::binary_search(set.visible, o);
      switch (answer.verdict[index_of(targets.objects[o])]) {
      case oracle::Verdict::visible:
        CHECK(is_visible);
        ++seen;
        break;
      case oracle::Verdict::hidden:
        CHECK(!is_visible);
        ++hidden;
        break;
      case oracle::Verdict::undecided: ++undecided; break;
      }
    }
  });
  CAPTURE(seen, hidden, undecided);
  CHECK(seen > trials(100));
  CHECK(hidden > trials(100));
  CHECK(undecided <= trials(10));
}

TEST_CASE("exact-2.5d: visible occludees do not depend on arithmetic or on how they are looked for", "[methods][law]")
{
  for_cases(15, [&](HeightCase const& c, std::vector<oracle::Occludee> const& occludees, Random& random) {
    Scene const targets = scene_of(occludees);
    Both const both(c.scene, targets);
    auto const cell = ViewCell::hull(c.cell);
    auto const expected = visible(both, cell);
    CHECK(visible<Rational>(both, cell) == expected);
    Options options;
    options.hierarchical_culling = random.chance(0.5);
    options.penumbra_wedges = random.chance(0.5);
    options.sampled_lines = random.chance(0.5);
    CHECK(visible(both, cell, options) == expected);
  });
}

TEST_CASE("exact-2.5d: simulated methods show more occludees, not fewer", "[methods][law]")
{
  for_cases(6, [&](HeightCase const& c, std::vector<oracle::Occludee> const& occludees, Random&) {
    Scene const targets = scene_of(occludees);
    Both const both(c.scene, targets);
    auto const cell = ViewCell::hull(c.cell);
    auto const expected = visible(both, cell);
    Options shrunk, wedges;
    shrunk.occluder_shrink = 0.05;
    wedges.occlusion = exact_25d::Occlusion::single_wedges;
    CHECK(std::ranges::includes(visible(both, cell, shrunk), expected));
    CHECK(std::ranges::includes(visible(both, cell, wedges), expected));
    CHECK(Exact25d<>(shrunk)(both.field, both.occludees, cell).guarantee == Guarantee::none);
  });
}

TEST_CASE("exact-2.5d: occludees, by hand", "[methods][degenerate]")
{
  ViewCell const cell(box(-1, -1, 0, 1, 1, 2));
  auto const sees = [&](std::vector<Box> const& occluders, Box const& target) {
    Scene const hiding = box_scene(occluders), looked_for = box_scene({target});
    return !visible(Both(hiding, looked_for), cell).empty();
  };
  Box const wall = box(5, -20, 0, 6, 20, 10);
  SECTION("behind a wall; higher than it; beside it")
  {
    CHECK(!sees({wall}, box(8, -1, 0, 9, 1, 8)));
    CHECK(sees({wall}, box(8, -1, 0, 9, 1, 30)));
    CHECK(sees({wall}, box(8, 30, 0, 9, 31, 1)));
  }
  SECTION("a box that floats above the wall is seen, one inside the wall is not")
  {
    CHECK(sees({wall}, box(5, -1, 12, 6, 1, 13)));
    CHECK(!sees({wall}, box(5.25, -1, 2, 5.75, 1, 3)));
  }
  SECTION("a box flush with the wall's near face shows it, one flush with the far face does not")
  {
    CHECK(sees({wall}, box(5, -1, 2, 5.5, 1, 3)));
    CHECK(!sees({wall}, box(5.5, -1, 2, 6, 1, 3)));
  }
  SECTION("occludees do not hide each other, nor the ground under a tower")
  {
    Scene const hiding = box_scene({wall}),
                looked_for = box_scene({box(2, -20, 0, 3, 20, 10), box(4, -1, 0, 4.5, 1, 1)});
    CHECK(visible(Both(hiding, looked_for), cell) == Indices{0, 1});
  }
  SECTION("a plate under the cell is seen unless a column covers it there")
  {
    CHECK(sees({box(50, 50, -5, 51, 51, -4)}, box(-3, -3, -2, 3, 3, -2)));
    CHECK(!sees({box(-4, -4, -5, 4, 4, -1)}, box(-3, -3, -2, 3, 3, -2)));
    CHECK(sees({box(-4, -4, -5, 4, 0.5, -1)}, box(-3, -3, -2, 3, 3, -2)));
  }
  SECTION("a long slope is seen only before the tower that stands on it")
  {
    Scene const hiding = box_scene({box(3, -9, 0, 3.5, 9, 2.5), box(6, -9, 0, 30, 9, 20)});
    SceneBuilder builder("slope");
    builder.begin_object("slope");
    builder.add_triangle(builder.add_vertex({4, -1, 0}), builder.add_vertex({4, 1, 0}),
                         builder.add_vertex({12, 0, 16}));
    Scene const slope = builder.finish();
    CHECK(visible(Both(hiding, slope), cell) == Indices{0});
    // The same with the tower right behind the wall.
    Scene const close = box_scene({box(3, -9, 0, 3.5, 9, 2.5), box(4, -9, 0, 30, 9, 20)});
    CHECK(visible(Both(close, slope), cell).empty());
  }
}
