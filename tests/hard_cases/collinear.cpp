#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

ViewCell cell() { return ViewCell(Box{{-1, -1, 1}, {1, 1, 2}}); }

HardCase alternating(std::string const& name, std::string const& why, double south, double north, double last,
                     bool visible)
{
  HardCase c{
    "collinear",
    name,
    "Lines must pass above y = a at x = 3, below y = b at x = 5, above y = c at x = 7. As y is linear in x, and "
    "these are equidistant, some do iff (a + c) / 2 < b. " +
      why,
    Stage()
      .box("first", {3, -100}, {4, south}, 50)
      .box("second", {4, north}, {5, 100}, 50)
      .box("third", {7, -100}, {8, last}, 50)
      .box("target", {10, last - 2}, {11, last + 4}, 3)
      .scene(),
    cell(),
    {"first", "second", "third"}};
  if (visible) c.visible.emplace_back("target");
  return c;
}

}  // namespace

Cases collinear()
{
  Cases out;
  out.push_back(alternating("three corners on a line, alternating", "1.5, 2.5, 3.5: equal.", 1.5, 2.5, 3.5, false));
  out.push_back(
    alternating("three corners an ulp off a line, open", "3.5 is an ulp less.", 1.5, 2.5, below(3.5), true));
  out.push_back(
    alternating("three corners an ulp off a line, closed", "3.5 is an ulp more.", 1.5, 2.5, above(3.5), false));
  out.push_back(alternating(
    "0.1, 0.2, 0.3 as doubles",
    "In units of 2^-55 they are 3602879701896397, 7205759403792794 and 10808639105689190 (0.3 is rounded down, "
    "0.1 up): the sum of the outer ones is 14411518807585587, one less than twice the middle.",
    .1, .2, .3, true));
  out.push_back(
    alternating("0.1, 0.2, 0.1 + 0.2 as doubles",
                "The sum 0.1 + 0.2 is rounded up to 10808639105689192 units, one more than three times 0.1: closed.",
                .1, .2, .1 + .2, false));
  out.push_back({"collinear",
                 "three curtains that end on a line",
                 "As with boxes: (1.5 + 3.5) / 2 = 2.5, so no line passes.",
                 Stage()
                   .curtain("first", {3, -100, 50}, {3, 1.5, 50})
                   .curtain("second", {5, 2.5, 50}, {5, 100, 50})
                   .curtain("third", {7, -100, 50}, {7, 3.5, 50})
                   .box("target", {10, 2}, {11, 8}, 3)
                   .scene(),
                 cell(),
                 {"first", "second", "third"}});
  out.push_back(
    {"collinear",
     "a row of walls whose corners lie on the line from the cell's corner",
     "All corners (k, k + 2) lie on the line y = x + 2 through the cell's corner (-1, 1); the open cell has "
     "y < x + 2. Lines that pass above the first wall's corner are steeper and stay above: they never come "
     "down to what touches the line from below.",
     Stage()
       .box("first", {3, -100}, {3.5, 5}, 50)
       .box("second", {4, -100}, {4.5, 6}, 50)
       .box("third", {5, -100}, {5.5, 7}, 50)
       .box("target", {6, 0}, {7, 8}, 3)
       .scene(),
     cell(),
     {"first"}});
  return out;
}

}  // namespace visibility::hard_cases
