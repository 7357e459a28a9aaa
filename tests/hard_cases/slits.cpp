#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

/// A wall from y0 - 100 to y0 + 100 with an opening (low, high), seen from around y0.
HardCase slit(std::string const& name, double y0, double low, double high)
{
  HardCase c{
    "slits",
    name,
    "The level line at the middle of the opening passes both boxes; if it has no width, they touch or overlap.",
    Stage()
      .box("north", {3, high}, {4, y0 + 100}, 50)
      .box("south", {3, y0 - 100}, {4, low}, 50)
      .box("target", {10, y0 - 1}, {11, y0 + 1}, 3)
      .scene(),
    ViewCell(Box{{-1, y0 - 1, 1}, {1, y0 + 1, 2}}),
    {"north", "south"}};
  if (low < high) {
    c.visible.emplace_back("target");
    c.sight_lines.push_back({"target", {0, middle(low, high), 1.5}, {10, middle(low, high), 1.5}});
  }
  return c;
}

/// Prisms with the sides (3, 0) - (6, 1) below and (3, a) - (6, b) above.
HardCase slanting_slit(std::string const& name, std::string const& why, double a, double b, bool visible)
{
  HardCase c{"slits",
             name,
             why,
             Stage()
               .prism("north", {{3, a}, {6, b}, {6, 100}, {3, 100}}, 50)
               .prism("south", {{3, -100}, {6, -100}, {6, 1}, {3, 0}}, 50)
               .box("target", {10, 0}, {11, 5}, 3)
               .scene(),
             ViewCell(Box{{-1, -2, 1}, {1, 1, 2}}),
             {"north", "south"}};
  if (visible) c.visible.emplace_back("target");
  return c;
}

/// Two walls with openings (1, 1 + u) and (1 + k u, 1 + (k + 1) u), u = 2^-52.
HardCase two_slits(std::string const& name, std::string const& why, int k, bool visible)
{
  double const u = 0x1p-52;
  HardCase c{"slits",
             name,
             why,
             Stage()
               .box("north", {3, 1 + u}, {4, 100}, 50)
               .box("south", {3, -100}, {4, 1}, 50)
               .box("second north", {6, 1 + (k + 1) * u}, {7, 100}, 50)
               .box("second south", {6, -100}, {7, 1 + k * u}, 50)
               .box("target", {10, -1}, {11, 3}, 3)
               .scene(),
             ViewCell(Box{{-1, 0, 1}, {1, 2, 2}}),
             {"north", "south"}};
  c.visible.emplace_back("second south");
  if (!visible) return c;
  c.visible.emplace_back("second north");
  c.visible.emplace_back("target");
  RationalNumber const rise = RationalNumber(k * u) / 3, at_3 = k == 0 ? middle(1, 1 + u) : 1 + rise;
  c.sight_lines.push_back({"target", {0, at_3 - 3 * rise, 1.5}, {10, at_3 + 7 * rise, 1.5}});
  return c;
}

}  // namespace

Cases slits()
{
  Cases out;
  out.push_back(slit("one ulp at 1/2", 0, .5, above(.5)));
  out.push_back(slit("one ulp at 1000", 1000, 1000.5, above(1000.5)));
  out.push_back(slit("no width", 0, .5, .5));
  out.push_back(slit("an ulp of overlap", 0, above(.5), .5));
  out.push_back(slit("the least number wide", 0, 0, 0x1p-1074));
  out.push_back(slit("the least number wide, on both sides of zero", 0, -0x1p-1074, 0x1p-1074));
  double const u = 0x1p-52;
  auto parallel = slanting_slit(
    "slanting, parallel sides",
    "(3, 2^-52) - (6, 1 + 2^-52) is (3, 0) - (6, 1) moved up: the line between them passes.", u, 1 + u, true);
  parallel.sight_lines.push_back(
    {"target", {0, RationalNumber(-1) + middle(0, u), 1.5}, {10, RationalNumber(7) / 3 + middle(0, u), 1.5}});
  out.push_back(std::move(parallel));
  out.push_back(slanting_slit("slanting, closing to a point",
                              "Both sides end in (6, 1): a line would have to pass above and below that point.", u, 1,
                              false));
  out.push_back(slanting_slit("slanting, opening from a point",
                              "Both sides begin in (3, 0): a line would have to pass above and below that point.", 0,
                              1 + u, false));
  std::string const rise = "Lines with 1 < y(3) and y(4) < 1 + u rise by less than u per unit of x. ";
  out.push_back(two_slits("two in line", rise + "The level line between passes both.", 0, true));
  out.push_back(
    two_slits("two that a slanting line passes", rise + "y = 1 + u / 3 + (x - 3) u / 3 passes both.", 1, true));
  out.push_back(two_slits("two that no line passes",
                          rise + "To pass above 1 + 3 u at x = 6 after y(4) < 1 + u they would have to rise by more; "
                                 "so they all end at the wall below that.",
                          3, false));
  return out;
}

}  // namespace visibility::hard_cases
