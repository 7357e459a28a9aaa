#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

/// Walls at x + 2, x + 4, x + 6 with the tops z = 2 y + 2, 4 y + 5/4, 6 y; a target at x + 8 with the top z = 8 y - a,
/// 0 <= y <= 1; a cell of depth 8 before x, 0 <= y <= 1, with the top z = -a. `side` = -1: mirrored, y becomes -y.
HardCase three_edges(std::string const& name, double a, double x, double side, bool visible)
{
  auto const edge = [&](double c, double y0, double y1, double raised) {
    return std::pair(Point3d{x + c, side * y0, c * y0 + raised}, Point3d{x + c, side * y1, c * y1 + raised});
  };
  double const bottom = -1000;
  Stage s;
  for (auto const& [wall, c, raised] :
       {std::tuple("first", 2., 2.), std::tuple("second", 4., 1.25), std::tuple("third", 6., 0.)}) {
    auto const [p, q] = edge(c, -64, 64, raised);
    s.curtain(wall, p, q, bottom);
  }
  auto const [p, q] = edge(8, 0, 1, 0);
  s.curtain("target", {p.x, p.y, -a}, {q.x, q.y, 8 - a}, bottom);
  Box cell{{x - 8, 0, -a - 1}, {x, 1, -a}};
  if (side < 0) cell = {{x - 8, -1, -a - 1}, {x, 0, -a}};
  HardCase out{
    "slanting edges",
    name,
    "Along a line f(c) = z - c y is quadratic in c = x, with f = d y0 - a at most at the cell's top, d before x = 0, "
    "and f = -a at most at the target's. With q = (y8 - y0) / (8 + d) it is there between the chord plus q (c + d) (8 "
    "- c): "
    "f(6) <= 2 (y8 (6 + d) - 6 y0) / (8 + d) - a <= 7/4 - a, and the third wall is passed iff f(6) > 0. For a < 7/4 "
    "the "
    "line from (-8, 0) to (8, 1) passes all three, and for a = 7/4 it touches all three.",
    s.scene(),
    ViewCell(cell),
    {"first", "second", "third"}};
  if (!visible) return out;
  out.visible.emplace_back("target");
  RationalNumber const e(0x1p-60), height(-a);
  out.sight_lines.push_back({"target",
                             {RationalNumber(x) - 8 + e, RationalNumber(side) * e, height - e},
                             {RationalNumber(x) + 8, RationalNumber(side) * (1 - e), height + 8 - 9 * e}});
  return out;
}

/// One unit in the last place of the target's height, near 6.25; the cell's, 1.75 -+ ulp, is a double as well.
constexpr double ulp = 0x1p-50;

/// Walls and beams across the view, upright: the three corners of "collinear", now in z, where no height field is.
HardCase beams(std::string const& name, double third, bool visible)
{
  HardCase c{
    "slanting edges",
    name,
    "Lines must pass above z = 3/2 at x = 3, below 5/2 at x = 5, above the third at x = 7: some do iff 3/2 and it add "
    "up to less than 5.",
    Stage()
      .box("first", Box{{3, -100, -100}, {4, 100, 1.5}})
      .box("second", Box{{4, -100, 2.5}, {5, 100, 100}})
      .box("third", Box{{7, -100, -100}, {8, 100, third}})
      .box("target", Box{{10, -1, 2}, {11, 1, 8}})
      .scene(),
    ViewCell(Box{{-1, -1, -1}, {1, 1, 1}}),
    {"first", "second", "third"},
    {},
    false};
  if (visible) c.visible.emplace_back("target");
  return c;
}

}  // namespace

Cases slanting()
{
  Cases out;
  out.push_back(three_edges("three slanting edges, an ulp open", 1.75 - ulp, 0, 1, true));
  out.push_back(three_edges("three slanting edges on one line", 1.75, 0, 1, false));
  out.push_back(three_edges("three slanting edges, an ulp closed", 1.75 + ulp, 0, 1, false));
  out.push_back(three_edges("three slanting edges mirrored, an ulp open", 1.75 - ulp, 0, -1, true));
  out.push_back(three_edges("three slanting edges mirrored, on one line", 1.75, 0, -1, false));
  out.push_back(three_edges("three slanting edges far off, an ulp open", 1.75 - ulp, 1e7, 1, true));
  out.push_back(three_edges("three slanting edges far off, on one line", 1.75, 1e7, 1, false));
  out.push_back(beams("a beam between two walls, on one line", 3.5, false));
  out.push_back(beams("a beam between two walls, an ulp open", below(3.5), true));
  return out;
}

}  // namespace visibility::hard_cases
