// Scenes small enough to decide by hand.

#include "scenes.hpp"
#include "support/catch.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using oracle::Verdict;

namespace {

double above(double x) { return std::nextafter(x, HUGE_VAL); }
double below(double x) { return std::nextafter(x, -HUGE_VAL); }

/// 'v', 'h' or '?' for each object; every visible one that does not meet the cell has a good witness.
std::string seen(std::vector<Column> const& columns, Cell const& cell = unit_cell)
{
  std::uint32_t objects = 0;
  for (auto const& c : columns) objects = std::max(objects, c.object + 1);
  auto const answer = oracle::visible_objects(columns, objects, cell);
  std::string text;
  for (std::uint32_t o = 0; o < objects; ++o) {
    auto const& w = answer.witness[o];
    text += answer.verdict[o] == Verdict::visible ? 'v' : answer.verdict[o] == Verdict::hidden ? 'h' : '?';
    if (w) CHECK((w->object == o && oracle::confirms(columns, cell, *w)));
    bool const touches =
      std::ranges::any_of(columns, [&](Column const& c) { return c.object == o && oracle::meets(c, cell); });
    CHECK(w.has_value() == (answer.verdict[o] == Verdict::visible && !touches));
  }
  return text;
}

Column wide_wall(std::uint32_t object, double x, double top) { return box(object, x, -50, x + 1, 50, top); }
Column house(std::uint32_t object, double x, double top) { return box(object, x, 0, x + 1, 1, top); }

}  // namespace

TEST_CASE("height field oracle: a wall hides what is lower, up to the line from the back of the cell's top",
          "[height_field]")
{
  // From (0, 1) over the wall's near edge (4, 3): height 5 at x = 8.
  for (double top : {-2.0, 1.0, 4.9, below(5.0), 5.0}) CHECK(seen({wide_wall(0, 4, 3), house(1, 8, top)}) == "vh");
  for (double top : {above(5.0), 5.1, 9.0}) CHECK(seen({wide_wall(0, 4, 3), house(1, 8, top)}) == "vv");
  // A shallow cell cannot stand back: from (0.5, 1), height 5 2/7.
  Cell const shallow{{{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}}, 0, 1};
  CHECK(seen({wide_wall(0, 4, 3), house(1, 8, 5.28)}, shallow) == "vh");
  CHECK(seen({wide_wall(0, 4, 3), house(1, 8, 5.29)}, shallow) == "vv");
}

TEST_CASE("height field oracle: from above, the front of the cell's top looks furthest down", "[height_field]")
{
  // From (1, 1) over the far edge (3, -1) of a wall: height -5 at x = 7. The house's top reaches to x = 8: -6.
  for (double top : {-4.5, above(-6.0)}) CHECK(seen({wide_wall(0, 2, -1), house(1, 7, top)}) == "vv");
  for (double top : {-6.0, -7.0}) CHECK(seen({wide_wall(0, 2, -1), house(1, 7, top)}) == "vh");
}

TEST_CASE("height field oracle: at the height of the cell's top nothing is seen over its equal", "[height_field]")
{
  CHECK(seen({wide_wall(0, 4, 1), house(1, 8, 1)}) == "vh");
  CHECK(seen({wide_wall(0, 4, 1), house(1, 8, above(1.0))}) == "vv");
  CHECK(seen({wide_wall(0, 4, below(1.0)), house(1, 8, 1)}) == "vv");
  CHECK(seen({wide_wall(0, 4, 1), house(1, 5, 1)}) == "vh");      // abutting
  CHECK(seen({wide_wall(0, 4, 0.9), house(1, 5, 0.9)}) == "vv");  // its roof
}

TEST_CASE("height field oracle: two walls that overlap in depth fuse", "[height_field]")
{
  Column const left = box(0, 4, -50, 5, 0.6, 10), right = box(1, 6, 0.4, 7, 50, 10), goal = box(2, 20, 0.4, 21, 0.6, 2);
  CHECK(seen({left, right, goal}) == "vvh");
  CHECK(seen({left, goal}) == "vhv");
  CHECK(seen({right, goal}) == "hvv");
}

TEST_CASE("height field oracle: abutting walls leave no slit, one unit in the last place does", "[height_field]")
{
  Column const left = box(0, 4, -50, 5, 0.5, 10), goal = box(2, 8, 0, 9, 1, 2);
  CHECK(seen({left, box(1, 4, 0.5, 5, 50, 10), goal}) == "vvh");
  CHECK(seen({left, box(1, 4, above(0.5), 5, 50, 10), goal}) == "vvv");
  CHECK(seen({left, box(1, 4, below(0.5), 5, 50, 10), goal}) == "vvh");
  // Corner to corner across: the free lines have no width.
  CHECK(seen({left, box(1, 5, 0.5, 6, 50, 10), goal}) == "vvh");
  // Apart by the width of a hair, they let lines along the hair's breadth through.
  CHECK(seen({left, box(1, above(5.0), 0.5, 6, 50, 10), goal}) == "vvv");
}

TEST_CASE("height field oracle: below the cell, roofs are seen from right above", "[height_field]")
{
  Column const roof = box(0, -5, -5, 6, 6, -1);
  CHECK(seen({roof}) == "v");
  CHECK(seen({roof, box(1, -6, -6, 7, 7, -0.5)}) == "hv");
  CHECK(seen({roof, box(1, -6, -6, 7, 7, -1)}) == "vv");  // one top is in the other
  CHECK(seen({roof, box(1, -6, -6, 7, 7, above(-1.0))}) == "hv");
  CHECK(seen({roof, box(1, 0.5, -6, 7, 7, -0.5)}) == "vv");
  CHECK(seen({box(0, 0.2, 0.2, 0.4, 0.4, -9), box(1, 0.4, 0.2, 0.6, 0.4, -1)}) == "vv");
  // A well: its bottom is seen from right above only, its walls with a shallow angle.
  std::vector<Column> well{box(0, 0.25, 0.25, 0.75, 0.75, -1e6)};
  for (auto [x0, y0, x1, y1] :
       {std::array{-9., -9., .25, 9.}, {.75, -9., 9., 9.}, {-9., -9., 9., .25}, {-9., .75, 9., 9.}})
    well.push_back(box(std::uint32_t(well.size()), x0, y0, x1, y1, -0.5));
  CHECK(seen(well) == "vvvvv");
}

TEST_CASE("height field oracle: what meets the closed cell is visible without a witness", "[height_field]")
{
  CHECK(seen({box(0, 1, 1, 2, 2, 0)}) == "v");  // a corner of the cell
  CHECK(seen({box(0, 0.2, 0.2, 0.4, 0.4, 0.5)}) == "v");
  CHECK(seen({box(0, 1, 0, 2, 1, 9)}) == "v");  // stands at the cell's wall, higher
  CHECK(seen({box(0, 1, -50, 2, 50, 9), house(1, 4, 5)}) == "vh");
  CHECK(seen({box(0, 1, -50, 2, 50, 1), house(1, 2, 1)}) == "vh");
  CHECK(seen({box(0, 1, -50, 2, 50, below(1.0)), house(1, 2, 1)}) == "vv");
}

TEST_CASE("height field oracle: a wall under the cell's side, seen by its tip over what abuts", "[height_field]")
{
  Cell const high{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 3, 4};
  // The wall on x = 1 rises from height 0 to its tip at y = 0; the top behind it is covered.
  auto const scene = [](double tip) {
    return std::vector{triangle(0, {1, 1, 0}, {1, 0, tip}, {1.5, 0.5, 0}), box(1, -9, -9, 1, 9, 1),
                       box(2, 1, -1, 2, 2, 2)};
  };
  CHECK(seen(scene(1), high) == "hvv");
  CHECK(seen(scene(1 + 0x1p-20), high) == "vvv");
}

TEST_CASE("height field oracle: columns in the cell hide like others", "[height_field]")
{
  Column const inside = box(0, 0.25, 0.25, 0.75, 0.75, 0.75);
  CHECK(seen({inside, house(1, 3, -1)}) == "vv");
  CHECK_THROWS_AS(seen({box(0, 0.25, 0.25, 0.75, 0.75, 1)}), std::invalid_argument);
  CHECK_THROWS_AS(seen({triangle(0, {0, 0, -9}, {1, 0, -9}, {1, 1, 2})}), std::invalid_argument);
}

TEST_CASE("height field oracle: coincident columns are both visible, nested ones are not", "[height_field]")
{
  CHECK(seen({house(0, 4, 3), house(1, 4, 3)}) == "vv");
  CHECK(seen({house(0, 4, 3), house(1, 4, 2)}) == "vv");  // its wall
  CHECK(seen({box(0, 4, 0, 6, 1, 3), box(1, 4.5, 0.25, 5.5, 0.75, 3)}) == "vh");
  // From (0, 1) over (4, 3): height 3.25 at x = 4.5.
  CHECK(seen({box(0, 4, 0, 6, 1, 3), box(1, 4.5, 0.25, 5.5, 0.75, 3.25)}) == "vh");
  CHECK(seen({box(0, 4, 0, 6, 1, 3), box(1, 4.5, 0.25, 5.5, 0.75, above(3.25))}) == "vv");
  CHECK(seen({box(0, 4, 0, 6, 1, 0.5), box(1, 4.5, 0.25, 5.5, 0.75, 0.5)}) == "vv");  // one top in the other
}

TEST_CASE("height field oracle: sides that are no faces are not seen", "[height_field]")
{
  // The only wall towards the cell, of a column whose top faces away.
  Column c = box(0, 4, 0, 5, 1, 3);
  CHECK(seen({c}) == "v");
  c.inner = {true, false, true, true};
  CHECK(seen({c}) == "h");
  c.inner = {true, true, true, false};
  CHECK(seen({c}) == "v");
}

TEST_CASE("height field oracle: slanted tops", "[height_field]")
{
  // A ramp that rises from height 1 at x = 4 away from the cell to its tip (6, 0, 3).
  Column const ramp = triangle(0, {4, -9, 1}, {6, 0, 3}, {4, 9, 1});
  CHECK(seen({ramp, box(1, 4, -9, 4.5, 9, 1.5)}) == "vv");
  // Behind a wall, from (0, 1) over (3, 2): the tip's height is on the line exactly.
  CHECK(seen({ramp, box(1, 3, -30, 4, 30, 1.5)}) == "vv");
  CHECK(seen({ramp, box(1, 3, -30, 4, 30, 2)}) == "hv");
  CHECK(seen({ramp, box(1, 3, -30, 4, 30, below(2.0))}) == "vv");
  // Tops that cross: each is seen where it is the higher one.
  Column const falling = triangle(1, {4, -9, 3}, {6, 0, 1}, {4, 9, 3});
  Cell const high{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 9, 10};
  Column bare = ramp;
  bare.inner = {true, true, true};
  CHECK(seen({bare, falling}, high) == "vv");
  CHECK(seen({bare, falling, box(2, 4.5, -9, 6, 9, 3.5)}, high) == "hvv");
  CHECK(seen({ramp, falling, box(2, 4.5, -9, 6, 9, 3.5)}, high) == "vvv");  // walls that coincide
}

TEST_CASE("height field oracle: a pinwheel of walls closes the view, each one needed", "[height_field]")
{
  std::vector<Column> walls{box(0, 4.25, -3, 5, 6, 10), box(1, -5, 4.25, 4, 5, 10), box(2, -4, -5, -3.25, 4, 10),
                            box(3, -3, -4, 6, -3.25, 10)};
  std::vector<Column> const goals{box(4, 20, 0, 21, 1, 5), box(4, 0, 20, 1, 21, 5), box(4, -20, 0, -19, 1, 5),
                                  box(4, 0, -20, 1, -19, 5)};
  for (auto const& goal : goals) {
    auto scene = walls;
    scene.push_back(goal);
    CHECK(seen(scene) == "vvvvh");
  }
  for (std::size_t i = 0; i < 4; ++i) {
    auto scene = walls;
    scene.erase(scene.begin() + std::ptrdiff_t(i));
    scene.push_back(goals[i]);
    CHECK(seen(scene).back() == 'v');
  }
}

TEST_CASE("height field oracle: what is seen along a null set of lines is hidden", "[height_field][degenerate]")
{
  // proofs/visibility.md: two wedges that touch the wall in one line.
  std::vector<Column> const columns{box(0, 4, -4, 5, 4, 3), triangle(1, {4, 0, 9}, {4, 5, 9}, {3, 0.5, 9}),
                                    triangle(2, {4, 0, 9}, {3, -0.5, 9}, {4, -5, 9})};
  Cell const cell{{{0, -0.5}, {1, -0.5}, {1, 0.5}, {0, 0.5}}, 0, 1};
  CHECK(seen(columns, cell) == "hvv");
  CHECK(oracle::confirms(columns, cell, {0, exact(Point3d{0.5, 0, 0.5}), exact(Point3d{4, 0, 0.5})}));
}
