// Occludees in scenes small enough to decide by hand.

#include "occludees.hpp"
#include "scenes.hpp"
#include "support/catch.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using oracle::Occludee;
using oracle::Verdict;

namespace {

double above(double x) { return std::nextafter(x, HUGE_VAL); }
double below(double x) { return std::nextafter(x, -HUGE_VAL); }

/// Each one an occludee of its own; 'v', 'h' or '?'. Every visible one that does not meet the cell has a good witness.
std::string seen(std::vector<Column> const& columns, std::vector<Polygon> const& polygons, Cell const& cell = unit_cell)
{
  std::vector<Occludee> occludees;
  for (auto const& p : polygons) occludees.push_back({{p}});
  auto const answer = oracle::visible_occludees(columns, occludees, cell);
  std::string text;
  for (std::size_t i = 0; i < occludees.size(); ++i) {
    auto const& w = answer.witness[i];
    text += answer.verdict[i] == Verdict::visible ? 'v' : answer.verdict[i] == Verdict::hidden ? 'h' : '?';
    if (w) CHECK((w->object == i && oracle::confirms(columns, occludees[i], cell, *w)));
    CHECK(w.has_value() == (answer.verdict[i] == Verdict::visible && !oracle::meets(occludees[i], cell)));
  }
  return text;
}

Column wide_wall(double x0, double x1, double top) { return box(0, x0, -50, x1, 50, top); }
/// Across the view.
Polygon screen(double x, double low, double high) { return upright({x, 0}, {x, 1}, low, high); }
Polygon floor(double x0, double x1, double z) { return ramp(x0, x1, 0, 1, z, z); }

}  // namespace

TEST_CASE("occludees: over a wall they are seen from the far side of the cell only", "[height_field]")
{
  // From (0, 1) over the wall's near edge (4, 3): height 5 at x = 8.
  std::vector<Column> const wall{wide_wall(4, 5, 3)};
  CHECK(seen(wall, {screen(8, 0, 5), screen(8, 0, above(5.0)), screen(8, 6, 7), screen(8, -9, -8)}) == "hvvh");
  // From below, where they begin.
  CHECK(seen(wall, {floor(8, 20, 5), floor(below(8.0), 20, 5), floor(8, 20, above(5.0))}) == "hvv");
  CHECK(seen(wall, {ramp(8, 20, 0, 1, 5, 4), ramp(8, 20, 0, 1, above(5.0), 0)}) == "hv");
  // From above, where they end: height 11 at x = 20.
  CHECK(seen(wall, {ramp(8, 20, 0, 1, 0, 11), ramp(8, 20, 0, 1, 0, above(11.0))}) == "hv");
  // In the plane of the line along which the wall is grazed.
  CHECK(seen(wall, {ramp(8, 20, 0, 1, 5, 11), ramp(3, 20, 0, 1, 2.5, 11)}) == "hv");
  // A shallow cell cannot stand back: from (0.5, 1), height 5 2/7.
  Cell const shallow{{{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}}, 0, 1};
  CHECK(seen(wall, {screen(8, 0, 5.28), screen(8, 0, 5.29)}, shallow) == "hv");
}

TEST_CASE("occludees: down over an edge the near side of the cell's top looks furthest", "[height_field]")
{
  // From (1, 1) over the far edge (3, -1): height -5 at x = 7, -6 at x = 8.
  std::vector<Column> const wall{wide_wall(2, 3, -1)};
  CHECK(seen(wall, {screen(7, -9, -5), screen(7, -9, above(-5.0))}) == "hv");
  CHECK(seen(wall, {floor(3, 8, -6), floor(3, 8, above(-6.0)), floor(3, above(8.0), -6)}) == "hvv");
}

TEST_CASE("occludees: half inside a tower", "[height_field]")
{
  std::vector<Column> const tower{box(0, 4, 0, 6, 1, 3)};
  auto const along = [](double x0, double x1, double high) { return upright({x0, 0.5}, {x1, 0.5}, 0, high); };
  CHECK(seen(tower, {along(3, 5, 2), along(4, 5, 2), along(4.5, 5.5, 2), along(4, 6, 2)}) == "vhhh");
  CHECK(seen(tower, {along(below(4.0), 5, 2), along(4.5, 5.5, 3), along(4.5, 5.5, 3.5)}) == "vhv");
  CHECK(seen(tower, {floor(3, 5, 2), floor(4, 6, 2)}) == "vh");
  // Out of its top: from (0, 1) over (4, 3) the line is at height 4 at x = 6.
  CHECK(seen(tower, {ramp(4, 6, 0, 1, 2, 3), ramp(4, 6, 0, 1, 2, 4), ramp(4, 6, 0, 1, 2, 4.0625)}) == "hhv");
  // Behind it, or sticking out behind it.
  CHECK(seen(tower, {along(5, 9, 2), ramp(5, 9, 0.25, 0.75, 2, 2), ramp(5, 9, 0.5, 30, 2, 2)}) == "hhv");
}

TEST_CASE("occludees: a floor is seen before the tower that stands on it", "[height_field]")
{
  std::vector<Column> const tower{wide_wall(4, 90, 8)};
  auto const ground = [](double x0) { return ramp(x0, 90, -50, 50, -2, -2); };
  CHECK(seen(tower, {ground(2), ground(4), ground(below(4.0)), ground(above(4.0))}) == "vhvh");
  // Under the cell it is seen from right above, around what stands there.
  std::vector<Column> const stump{box(0, -3, -3, 0.5, 4, -1)};
  CHECK(seen(stump, {floor(0, 1, -2), floor(0, 0.5, -2), floor(0, 0.5, -1), floor(-9, 9, -1.5)}) == "vhvv");
}

TEST_CASE("occludees: under a slanted roof, in it and over it", "[height_field]")
{
  std::vector<Column> const roof{triangle(0, {4, -9, 1}, {6, 0, 0}, {4, 9, 1})};  // falls away from the cell
  auto const shifted = [](double dz) { return Polygon{{4, -9, 1 + dz}, {6, 0, dz}, {4, 9, 1 + dz}}; };
  auto const inside = [](double dz) { return Polygon{{4.5, -1, 0.75 + dz}, {5, 0, 0.5 + dz}, {4.5, 1, 0.75 + dz}}; };
  Cell const high{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 3, 4};
  CHECK(seen(roof, {shifted(0), shifted(-1e-9), shifted(1e-9), inside(0), inside(-1e-9)}, high) == "vhvvh");
  CHECK(seen(roof, {ramp(4, 5, 0, 1, 0.25, 0.75), ramp(4, 5, 0, 1, 0.25, 0.5)}, high) == "vh");  // pierces it or not
  // From where the roof faces away, only what stands out from it.
  CHECK(seen(roof, {inside(0), inside(-0.01), inside(0.125), inside(0.3), inside(1)}) == "hhhvv");
}

TEST_CASE("occludees: flush with a wall", "[height_field]")
{
  std::vector<Column> const wall{wide_wall(4, 5, 3)};
  CHECK(seen(wall, {screen(4, 0, 2), screen(4, -9, -8), screen(4, 0, 3), screen(4, 2, 4)}) == "vvvv");
  CHECK(seen(wall, {screen(above(4.0), 0, 3), screen(5, 0, 3), screen(5, 0, above(3.5)), screen(5, 0, 3.5)}) == "hhvh");
  // Covered by another column in front, which abuts.
  std::vector<Column> const two{wide_wall(4, 5, 3), box(1, 3, -50, 4, 50, 2)};
  CHECK(seen(two, {screen(4, 0, 2), screen(4, 0, 3), screen(3, 0, 1)}) == "hvv");
}

TEST_CASE("occludees: a vertical polygon that sticks out above a wall", "[height_field]")
{
  std::vector<Column> const wall{wide_wall(4, 5, 3)};
  Polygon const gable{{8, 0, 0}, {8, 1, 0}, {8, 1, 4}, {8, 0.5, 5.25}, {8, 0, 4}},
    low{{8, 0, 0}, {8, 1, 0}, {8, 0.5, 5}};
  CHECK(seen(wall, {gable, low}) == "vh");
  // Inside a wall, sticking out of its top.
  CHECK(seen(wall, {screen(4.5, 2, 3.25), screen(4.5, 2, 3.5), screen(4.25, 0, 3.125)}) == "hvh");
}

TEST_CASE("occludees: under the cell the tip of a vertical polygon sticks out of a roof", "[height_field]")
{
  Cell const high{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 3, 4};
  std::vector<Column> const roof{box(0, -9, -9, 9, 9, 1)};
  auto const tip = [](double x, double z) { return Polygon{{x, 1, 0}, {x, 0, z}, {x, 0, -1}}; };
  double const hair = 0x1p-20;
  CHECK(seen(roof, {tip(0.5, 1), tip(0.5, 1 + hair), tip(1, 1), tip(1, 1 + hair)}, high) == "hvhv");
  CHECK(seen({box(0, -9, -9, 1, 9, 1)}, {tip(1, 1 + hair)}, high) == "v");
}

TEST_CASE("occludees: through the slit between two towers", "[height_field]")
{
  Column const left = box(0, 4, -50, 5, 0.5, 10);
  CHECK(seen({left, box(1, 4, above(0.5), 5, 50, 10)}, {screen(8, 0, 2), floor(6, 7, 0)}) == "vv");
  CHECK(seen({left, box(1, 4, 0.5, 5, 50, 10)}, {screen(8, 0, 2), floor(6, 7, 0)}) == "hh");
  CHECK(seen({left, box(1, above(5.0), 0.5, 6, 50, 10)}, {upright({8, -30}, {8, 30}, 0, 2)}) == "v");
  // And over a wall before it: from (0, 1) over (2, 1.5), height 6 at x = 20.
  std::vector<Column> const both{left, box(1, 4, above(0.5), 5, 50, 10), box(2, 2, -50, 3, 50, 1.5)};
  CHECK(seen(both, {ramp(8, 20, 0, 1, 0, 6), ramp(8, 20, 0, 1, 0, 6.0625), ramp(8, 20, 0, 1, 6, 0)}) == "hvv");
  // What lies in the slit: edge on.
  CHECK(seen({left, box(1, 4, above(0.5), 5, 50, 10)}, {upright({4, 0.5}, {5, 0.5}, 0, 2)}) == "v");
  CHECK(seen({left, box(1, 4, 0.5, 5, 50, 10)}, {upright({4, 0.5}, {5, 0.5}, 0, 2)}) == "h");
}

TEST_CASE("occludees: coplanar with a top they are seen where that top is", "[height_field]")
{
  std::vector<Column> const slab{wide_wall(4, 9, 0.5)};
  CHECK(seen(slab, {floor(5, 6, 0.5), floor(5, 6, below(0.5)), floor(5, 6, 0.75), floor(4, 9, 0.5)}) == "vhvv");
  std::vector<Column> const covered{wide_wall(4, 9, 0.5), box(1, 5, -1, 6, 2, 0.625)};
  CHECK(seen(covered, {floor(5, 6, 0.5), floor(4.5, 6, 0.5), floor(6, 8, 0.5), floor(5, 6, 0.625)}) == "hvvv");
  // At the height of the cell's top, above which no eye is.
  CHECK(seen({wide_wall(4, 9, 1)}, {floor(5, 6, 1), floor(3, 6, 1)}) == "hv");
  CHECK(seen({wide_wall(4, 5, 1)}, {floor(8, 9, 1)}) == "h");
  CHECK(seen({wide_wall(4, 5, below(1.0))}, {floor(8, 9, 1)}) == "v");
}

TEST_CASE("occludees: seen between a shadow and the roof that they run into", "[height_field]")
{
  // The shadow of the wall is 5 + (x - 8) / 2; the polygon 4.875 + 3 (x - 8) / 4 rises out of it at x = 8.5 and goes
  // under the roof, of slope 1. Neither its ends nor any edge of the roof tells.
  auto const roof = [](double z) { return triangle(1, {8, -90, z}, {20, 0, z + 12}, {8, 90, z}); };
  // Two towers let no line through that meets it between its sides.
  Column const left = box(2, 2, -50, 3, 0.25, 50), right = box(3, 2, 0.75, 3, 50, 50);
  auto const shown = [&](double z) {
    return seen({wide_wall(4, 5, 3), roof(z), left, right}, {ramp(8, 10, -40, 40, 4.875, 6.375)});
  };
  CHECK(shown(4.5) == "v");
  CHECK(shown(4.7499) == "v");
  CHECK(shown(4.75) == "h");  // at x = 8.5 too
  CHECK(shown(4.8) == "h");
}

TEST_CASE("occludees: above the cell, in it and at its wall", "[height_field]")
{
  CHECK(seen({}, {floor(0, 1, 5), floor(0, 1, 1), floor(0, 1, 0.5), floor(-2, 0, 0), floor(0, 1, -3)}) == "vvvvv");
  CHECK(seen({}, {screen(0.5, 3, 4), screen(1, 3, 4), screen(0.5, -4, -3), screen(1, -4, -3)}) == "vvvv");
  // A high column at the cell's wall. From (0, 1) over its edge (1, 9): height 13 at x = 1.5.
  std::vector<Column> const flush{box(0, 1, -50, 2, 50, 9)};
  CHECK(seen(flush, {floor(1, 2, 9), floor(1, 2, above(9.0)), floor(1.5, 2, 13), floor(1.5, 2, above(13.0))}) ==
        "hvhv");
  CHECK(seen(flush, {screen(1, 5, 6), screen(1, 9, 10), screen(2, 5, 9), floor(0, 2, 9), floor(0, 2, -5)}) == "vvhvv");
  // The bottom of a well.
  std::vector<Column> const well{box(0, -9, -9, .25, 9, -0.5), box(1, .75, -9, 9, 9, -0.5),
                                 box(2, -9, -9, 9, .25, -0.5), box(3, -9, .75, 9, 9, -0.5)};
  CHECK(seen(well, {ramp(0.25, 0.75, 0.25, 0.75, -1e6, -1e6), floor(-3, 3, -9), floor(0, 0.25, -9)}) == "vvh");
}

TEST_CASE("occludees: occlude nothing", "[height_field]")
{
  CHECK(seen({}, {screen(2, -90, 90), screen(3, 0, 1), screen(3, 0, 1), floor(2, 4, 0.5)}) == "vvvv");
  // Both sides of a polygon are seen.
  Polygon const there{{3, 0, 0}, {4, 0, 2}, {3, 1, 0}}, back{{3, 1, 0}, {4, 0, 2}, {3, 0, 0}};
  CHECK(seen({}, {there, back}) == "vv");
}

TEST_CASE("occludees: a null set of lines shows nothing", "[height_field][degenerate]")
{
  std::vector<Column> const columns{triangle(0, {4, 0, 9}, {4, 5, 9}, {3, 0.5, 9}),
                                    triangle(1, {4, 0, 9}, {3, -0.5, 9}, {4, -5, 9})};
  Cell const cell{{{0, -0.5}, {1, -0.5}, {1, 0.5}, {0, 0.5}}, 0, 1};
  Polygon const wall = upright({4, -4}, {4, 4}, 0, 3);
  CHECK(seen(columns, {wall}, cell) == "h");
  CHECK(oracle::confirms(columns, Occludee{{wall}}, cell, {0, exact(Point3d{0.5, 0, 0.5}), exact(Point3d{4, 0, 0.5})}));
}

TEST_CASE("occludees: polygons without area count for nothing", "[height_field][degenerate]")
{
  CHECK(seen({}, {{}, {{3, 0, 0}}, {{3, 0, 0}, {3, 1, 1}}, {{3, 0, 0}, {3, 1, 1}, {3, 2, 2}}}) == "hhhh");
  CHECK(seen({}, {{{0.5, 0.5, 0}, {0.5, 0.5, 0.25}, {0.5, 0.5, 0.5}}}) == "h");  // even in the cell
  // Repeated corners and corners on sides are no matter.
  CHECK(seen({}, {{{3, 0, 0}, {3, 0, 0}, {4, 0, 0}, {4, 0, 0}, {5, 0, 0}, {4, 1, 0}, {3, 0, 0}}}) == "v");
  CHECK(seen({}, {{{3, 0, 0}, {3, 0, 0}, {3, 1, 0}, {3, 2, 0}, {3, 1, 1}, {3, 0.5, 0.5}}}) == "v");
}

TEST_CASE("occludees: several polygons, visible if one is", "[height_field]")
{
  std::vector<Column> const wall{wide_wall(4, 5, 3)};
  std::vector<Occludee> const both{{{screen(6, 0, 1), screen(8, 0, 9)}}, {{screen(6, 0, 1), floor(5, 8, 0)}}, {}};
  auto const answer = oracle::visible_occludees(wall, both, unit_cell);
  CHECK(answer.verdict == std::vector{Verdict::visible, Verdict::hidden, Verdict::hidden});
}

TEST_CASE("occludees: bad polygons are refused", "[height_field]")
{
  CHECK_THROWS_AS(seen({}, {{{3, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, 1, 1}}}), std::invalid_argument);
  CHECK_THROWS_AS(seen({}, {{{3, 0, 0}, {5, 0, 0}, {4, 0.25, 0}, {4, 2, 0}}}), std::invalid_argument);
  CHECK_THROWS_AS(seen({}, {{{3, 0, HUGE_VAL}, {5, 0, 0}, {4, 0.25, 0}}}), std::invalid_argument);
}

TEST_CASE("occludees: what is no sight line is not confirmed", "[height_field]")
{
  std::vector<Column> const columns{box(0, 3, 0, 3.5, 0.5, 2)};
  Occludee const occludee{{upright({4, 0}, {4, 1}, 0, 3), floor(5, 6, 0)}};
  auto const confirmed = [&](Point3d p, Point3d s) {
    return oracle::confirms(columns, occludee, unit_cell, {0, exact(p), exact(s)});
  };
  CHECK(confirmed({0.5, 0.75, 0.5}, {4, 0.75, 0.5}));
  CHECK(confirmed({0.5, 0.75, 0.5}, {5.5, 0.75, 0}));            // through itself
  CHECK_FALSE(confirmed({0.5, 0.75, 0}, {4, 0.75, 0.5}));        // from the cell's boundary
  CHECK_FALSE(confirmed({0.5, 0.75, 0.5}, {4, 0.75, 3}));        // an edge
  CHECK_FALSE(confirmed({0.5, 0.75, 0.5}, {4, 0.75, 3.5}));      // above it
  CHECK_FALSE(confirmed({0.5, 0.75, 0.5}, {4.125, 0.75, 0.5}));  // behind it
  CHECK_FALSE(confirmed({0.5, 0.25, 0.5}, {4, 0.25, 0.5}));      // through the column
  CHECK_FALSE(confirmed({0.5, 0.5, 0.5}, {4, 0.5, 0.5}));        // along its side
}
