// Where the edges of tops are seen, in scenes small enough to decide by hand.

#include "parts.hpp"
#include "scenes.hpp"
#include "support/catch.hpp"

using namespace visibility;
using namespace visibility::test;
using oracle::Crossing;
using Q = RationalNumber;

namespace {

double above(double x) { return std::nextafter(x, HUGE_VAL); }
double below(double x) { return std::nextafter(x, -HUGE_VAL); }

/// Sides of a box.
enum Side : std::size_t { front_y, far_x, back_y, near_x };

/// 'v' or 'h' at one, two and three quarters.
std::string quarters(std::vector<Column> const& columns, std::size_t column, std::size_t side, Crossing crossing,
                     Cell const& cell = unit_cell)
{
  std::string text;
  for (int i = 1; i < 4; ++i) text += sees(columns, column, side, crossing, Q(i) / 4, cell) ? 'v' : 'h';
  return text;
}

Column wide_wall(std::uint32_t object, double x0, double x1, double top) { return box(object, x0, -50, x1, 50, top); }
Column house(std::uint32_t object, double x, double top) { return box(object, x, 0, x + 1, 1, top); }
constexpr auto entering = Crossing::entering, leaving = Crossing::leaving;

}  // namespace

TEST_CASE("edges: entered over a wall if they stand out from its shadow", "[height_field][parts]")
{
  // From (0, 1) over (4, 3): height 5 at x = 8.
  CHECK(quarters({wide_wall(0, 4, 5, 3), house(1, 8, 5)}, 1, near_x, entering) == "hhh");
  CHECK(quarters({wide_wall(0, 4, 5, 3), house(1, 8, above(5.0))}, 1, near_x, entering) == "vvv");
  CHECK(quarters({wide_wall(0, 4, 5, 3), house(1, 8, 5)}, 0, near_x, entering) == "vvv");
  CHECK(quarters({house(0, 8, 5)}, 0, far_x, entering) == "hhh");  // through the house
  CHECK(quarters({house(0, 8, 5)}, 0, far_x, leaving) == "hhh");   // from under the top
  // A slanted edge, of height 4 to 6, stands out by half: t runs from (8, 1) to (8, 0).
  auto const slanted = [](double z) {
    return std::vector{wide_wall(0, 4, 5, 3), triangle(1, {8, 1, z}, {8, 0, 6}, {9, 0, 0})};
  };
  CHECK(quarters(slanted(4), 1, 0, entering) == "hhv");
  CHECK(sees(slanted(4), 1, 0, entering, Q(1) / 2 + Q(1e-12)));
}

TEST_CASE("edges: left over a top that is seen", "[height_field][parts]")
{
  CHECK(quarters({house(0, 4, below(1.0))}, 0, far_x, leaving) == "vvv");
  CHECK(quarters({house(0, 4, 1)}, 0, far_x, leaving) == "hhh");
  CHECK(quarters({house(0, 4, 0.5)}, 0, near_x, leaving) == "hhh");  // comes from the other side
  // From (1, 1) over (3, -1): height -6 at x = 8.
  CHECK(quarters({wide_wall(0, 2, 3, -1), house(1, 7, -6)}, 1, far_x, leaving) == "hhh");
  CHECK(quarters({wide_wall(0, 2, 3, -1), house(1, 7, above(-6.0))}, 1, far_x, leaving) == "vvv");
  CHECK(quarters({wide_wall(0, 2, 3, -1), house(1, 7, above(-6.0))}, 1, near_x, entering) == "hhh");
  // The same through a slit that shows no corner of the cell: its near side is looked from, in the middle.
  auto const slit = [](double top) {
    return std::vector{wide_wall(0, 2, 3, -1), house(1, 7, top), box(2, 4, -50, 5, 0.49, 9), box(3, 4, 0.51, 5, 50, 9)};
  };
  CHECK(quarters(slit(-6), 1, far_x, leaving) == "hhh");
  CHECK(quarters(slit(above(-6.0)), 1, far_x, leaving) == "hvh");
  // Under the cell, from right above, all around.
  for (std::size_t side = 0; side < 4; ++side) {
    CHECK(quarters({box(0, 0.25, 0.25, 0.75, 0.75, -2)}, 0, side, leaving) == "vvv");
    CHECK(quarters({box(0, 0.25, 0.25, 0.75, 0.75, 0.5)}, 0, side, entering) == "vvv");
    CHECK(quarters({box(0, 0, 0, 1, 1, -2)}, 0, side, leaving) == "vvv");
    CHECK(quarters({box(0, 0, 0, 1, 1, -2)}, 0, side, entering) == "hhh");
  }
  // At the cell's wall, higher than it.
  CHECK(quarters({box(0, 1, 0, 2, 1, 9)}, 0, near_x, entering) == "vvv");
  CHECK(quarters({box(0, 1, 0, 2, 1, 9)}, 0, near_x, leaving) == "hhh");
}

TEST_CASE("edges: seen in part beside a tower", "[height_field][parts]")
{
  // Past the corner (5, 0.5) from (1, 0): up to y = 0.875 at x = 8.
  std::vector<Column> const scene{box(0, 4, 0.5, 5, 50, 99), box(1, 8, -20, 9, 20, 2)};
  Q const limit = Q(19.125) / 40, hair(0x1p-60);
  CHECK(sees(scene, 1, near_x, entering, limit + hair));
  CHECK_FALSE(sees(scene, 1, near_x, entering, limit - hair));
  CHECK_FALSE(sees(scene, 1, near_x, entering, limit));
  CHECK(sees(scene, 1, near_x, entering, Q(0.999)));
}

TEST_CASE("edges: covered by a neighbour", "[height_field][parts]")
{
  auto const before = [](double top) { return std::vector{house(0, 4, 3), box(1, 3, 0, 4, 0.5, top)}; };
  CHECK(quarters(before(2), 0, near_x, entering) == "vvv");
  CHECK(quarters(before(below(3.0)), 0, near_x, entering) == "vvh");  // its shadow; the middle is a corner
  CHECK(sees({house(0, 4, 0.5), box(1, 3, 0, 4, 0.5, below(0.5))}, 0, near_x, entering, Q(3) / 4));
  CHECK_FALSE(sees({house(0, 4, 0.5), box(1, 3, 0, 4, 0.5, 0.5)}, 0, near_x, entering, Q(3) / 4));
  // On the top, just before the edge.
  auto const on = [](double top) { return std::vector{house(0, 4, 0.5), box(1, 4.5, 0, 5, 0.5, top)}; };
  CHECK(quarters(on(0.25), 0, far_x, leaving) == "vvv");
  CHECK(quarters(on(0.5), 0, far_x, leaving) == "vvv");
  CHECK(sees(on(above(0.5)), 0, far_x, leaving, Q(3) / 4));
  CHECK_FALSE(sees(on(above(0.5)), 0, far_x, leaving, Q(1) / 4));
  // A roof that comes down to the edge covers the top before it, one that rises to it does not.
  auto const roof = [](double z) {
    return std::vector{house(0, 4, 0.5), triangle(1, {5, -9, 0.5}, {5, 9, 0.5}, {4, 0, z})};
  };
  CHECK(quarters(roof(0.625), 0, far_x, leaving) == "hhh");
  CHECK(quarters(roof(0.5625), 0, far_x, leaving) == "hhh");  // less steep than the sight line
  CHECK(quarters(roof(0.375), 0, far_x, leaving) == "vvv");
}

TEST_CASE("edges: over a column across the cell's side, which is before the eye for some directions only",
          "[height_field][parts]")
{
  // Its side crosses x = 1 at y = 0.5. A slanted wall lets lines through that have y < 0.45 there, and no corner says
  // so.
  Cell const high{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 3, 4};
  auto const scene = [](double top) {
    return std::vector{box(0, 3, -29.4, 4, 30.6, 0), triangle(1, {2, -20, -18.525}, {2, 20, 21.475}, {1.9, 0, 1.475}),
                       triangle(2, {1.5, 0, top}, {0.5, 1, top}, {0.5, 0, top})};
  };
  CHECK_FALSE(sees(scene(3.99), 0, near_x, entering, Q(1) / 2, high));
  CHECK(sees(scene(3), 0, near_x, entering, Q(1) / 2, high));
}

TEST_CASE("edges: requirements", "[height_field][parts]")
{
  CHECK_THROWS_AS(sees({house(0, 4, 3)}, 0, 0, entering, Q(0)), std::invalid_argument);
  CHECK_THROWS_AS(sees({house(0, 4, 3)}, 0, 0, entering, Q(1)), std::invalid_argument);
  CHECK_THROWS_AS(sees({house(0, 4, 3)}, 0, 4, entering, Q(1) / 2), std::invalid_argument);
  CHECK_THROWS_AS(sees({house(0, 4, 3)}, 1, 0, entering, Q(1) / 2), std::invalid_argument);
}
