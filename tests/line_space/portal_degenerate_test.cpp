#include "portal_oracle.hpp"
#include "support/catch.hpp"
#include "visibility/line_space/portal_half_spaces.hpp"

#include <cmath>

using namespace visibility;
using namespace visibility::test;
using Edge = PortalSequence::Edge;

namespace {

/// Across the x axis, of constant height.
Edge across(double x, double z, double half_width = 1) { return {{x, half_width, z}, {x, -half_width, z}}; }

bool visible(Edge const& source, std::vector<Edge> const& occluders, Edge const& target)
{
  PortalSequence s{source, target, occluders, {}};
  add_end_points(s);
  auto const line = find_sight_line(s);
  REQUIRE(line.has_value() == has_sight_line(s));
  if (line) REQUIRE(is_sight_line(s, (*line)[0], (*line)[1]));
  return line.has_value();
}

double up(double x) { return std::nextafter(x, HUGE_VAL); }
double down(double x) { return std::nextafter(x, -HUGE_VAL); }

}  // namespace

TEST_CASE("has_sight_line: without occluders there is one", "[line_space][degenerate]")
{
  CHECK(visible(across(0, 1), {}, across(10, 1)));
  CHECK(visible(across(0, 1), {}, across(10, 5, 3)));
}

TEST_CASE("has_sight_line: parallel edges of equal height only graze; one ulp decides", "[line_space][degenerate]")
{
  for (double const z : {0.1, 3.0, 1e6 + 0.001}) {
    CAPTURE(z);
    CHECK(!visible(across(0, z), {across(5, z)}, across(10, z)));
    CHECK(visible(across(0, z), {across(5, down(z))}, across(10, z)));
    CHECK(!visible(across(0, z), {across(5, up(z))}, across(10, z)));
    CHECK(visible(across(0, z), {across(5, z)}, across(10, up(z))));
    CHECK(visible(across(0, up(z)), {across(5, z), across(3, z)}, across(10, z)));
    CHECK(!visible(across(0, down(z)), {across(5, z)}, across(10, z)));
    // One end alone is enough.
    CHECK(visible(across(0, z), {{{5, 1, down(z)}, {5, -1, z}}}, across(10, z)));
    CHECK(!visible(across(0, z), {{{5, 1, up(z)}, {5, -1, z}}}, across(10, z)));
  }
}

TEST_CASE("has_sight_line: edges in one slanted plane only graze; one ulp decides", "[line_space][degenerate]")
{
  // z = 1 + x / 4 + y / 2
  auto const slanted = [](double x, double raise) {
    return Edge{{x, 2, 2 + x / 4 + raise}, {x, -1, 0.5 + x / 4 + raise}};
  };
  double const ulp = 0x1p-50;
  CHECK(!visible(slanted(0, 0), {slanted(3, 0), slanted(7, 0)}, slanted(10, 0)));
  CHECK(visible(slanted(0, 0), {slanted(3, -ulp), slanted(7, -ulp)}, slanted(10, 0)));
  CHECK(!visible(slanted(0, 0), {slanted(3, -ulp), slanted(7, 0)}, slanted(10, 0)));
  CHECK(visible(slanted(0, ulp), {slanted(3, 0), slanted(7, -ulp)}, slanted(10, 0)));
}

TEST_CASE("has_sight_line: a gap in plan must be open; one ulp decides", "[line_space][degenerate]")
{
  auto const with_points = [](double left, double right) {
    PortalSequence s{across(0, 5), across(10, 5), {}, {}};
    add_end_points(s);
    s.points.push_back({{5, left}, PortalSequence::Side::left});
    s.points.push_back({{5, right}, PortalSequence::Side::right});
    auto const line = find_sight_line(s);
    if (line) REQUIRE(is_sight_line(s, (*line)[0], (*line)[1]));
    return line.has_value();
  };
  CHECK(!with_points(0.3, 0.3));  // one point on both sides
  CHECK(with_points(up(0.3), 0.3));
  CHECK(!with_points(down(0.3), 0.3));
  // Walls on alternate sides, corners in one line: only that line is left.
  PortalSequence s{across(0, 5), across(10, 5), {}, {}};
  add_end_points(s);
  s.points.push_back({{2, 0}, PortalSequence::Side::left});
  s.points.push_back({{5, 0}, PortalSequence::Side::right});
  CHECK(has_sight_line(s));
  s.points.push_back({{8, 0}, PortalSequence::Side::left});
  CHECK(!has_sight_line(s));
  s.points.back().point.y = 0x1p-1074;
  CHECK(has_sight_line(s));
}

TEST_CASE("has_sight_line: edges that share an end point, and edges along the sight line", "[line_space][degenerate]")
{
  Edge const source{{0, 1, 4}, {0, -1, 4}}, target{{10, 1, 4}, {10, -1, 4}};
  CHECK(visible(source, {{{0, 1, 4}, {5, -1, 3}}}, target));    // meets the source in its left end
  CHECK(!visible(source, {{{0, 1, 4}, {5, -1, 4}}}, target));   // and is in the plane of both
  CHECK(visible(source, {{{0, 1, 4}, {10, -1, 3}}}, target));   // diagonal, from end to end
  CHECK(!visible(source, {{{0, 1, 4}, {10, -1, 4}}}, target));  // in the plane
  CHECK(!visible(source, {source}, target));                    // the source itself
  CHECK(visible({{0, 1, 4}, {3, -1, 4}}, {}, {{0, 1, 4}, {3, -2, 4}}));
  // The same plan line for source and target, the same edge: sight lines cross both at one point of the plan.
  CHECK(visible(source, {}, source));
  CHECK(visible(source, {{{0, 1, 3}, {0, -1, 3}}}, source));
}

TEST_CASE("has_sight_line: an edge without extent in plan has no sides", "[line_space][degenerate]")
{
  CHECK(!visible(across(0, 5), {{{5, 0, 1}, {5, 0, 1}}}, across(10, 5)));
  CHECK(!visible(across(0, 5), {{{5, 0, 1}, {5, 0, 3}}}, across(10, 5)));
}

TEST_CASE("has_sight_line: three edges on a saddle", "[line_space][degenerate]")
{
  // On the saddle z = x y / 10 all lines y = const touch source, occluder and target. A line from y = -w to y = w
  // passes x = 5 by w / 2 above it, and w < 2.
  auto const saddle = [](double x, double raise) { return Edge{{x, 2, x / 5 + raise}, {x, -2, -x / 5 + raise}}; };
  CHECK(visible(saddle(0, 0), {saddle(5, 0)}, saddle(10, 0)));
  CHECK(visible(saddle(0, 0), {saddle(5, 1 - 0x1p-40)}, saddle(10, 0)));
  CHECK(!visible(saddle(0, 0), {saddle(5, 1)}, saddle(10, 0)));
  CHECK(visible(saddle(0, 0), {saddle(5, 0)}, {{10, 2, 2.5}, {10, -2, -2.5}}));
}

TEST_CASE("integer_frame: coordinates of any size and distance", "[line_space][degenerate]")
{
  CHECK(visible(across(0, 0x1p-1060), {across(0x1p-1070, 0x1p-1062)}, across(0x1p-1060, 0x1p-1060)));
  CHECK(visible(across(-0x1p900, 4), {across(0x1p-900, 3)}, across(0x1p900, 4)));
  CHECK(!visible(across(-0x1p900, 4), {across(0x1p-900, 4)}, across(0x1p900, 4)));
  CHECK(visible(across(-1e300, 0x1p-1074), {across(1e-300, 0)}, across(1e300, 0x1p-1074)));
}
