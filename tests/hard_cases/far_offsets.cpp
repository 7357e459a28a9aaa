#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

/// Cases of other kinds, moved by o in x and y. All coordinates stay doubles.
void add(Cases& out, double o, std::string const& where)
{
  ViewCell const cell(Box{{o - 1, o - 1, 1}, {o + 1, o + 1, 2}});
  auto const wall = [&](std::string const& name, std::string const& why, double low, double high) {
    HardCase c{"far offset",
               name + where,
               why,
               Stage()
                 .box("north", {o + 3, high}, {o + 4, o + 100}, 50)
                 .box("south", {o + 3, o - 100}, {o + 4, low}, 50)
                 .box("target", {o + 10, o - 1}, {o + 11, o + 1}, 3)
                 .scene(),
               cell,
               {"north", "south"}};
    if (low < high) {
      c.visible.emplace_back("target");
      c.sight_lines.push_back({"target", {o, middle(low, high), 1.5}, {o + 10, middle(low, high), 1.5}});
    }
    return c;
  };
  out.push_back(wall("abutting boxes at ", "Closed boxes touch.", o + .5, o + .5));
  out.push_back(
    wall("a slit of one ulp at ", "The level line in the middle of the opening passes.", o + .5, above(o + .5)));
  for (bool const visible : {false, true}) {
    HardCase c{"far offset",
               (visible ? "a roof an ulp above the line over a wall at " : "a roof on the line over a wall at ") +
                 where,
               "As near zero: lines over the wall pass x + 11 above z = 5.",
               Stage()
                 .box("wall", {o + 3, o - 100}, {o + 4, o + 100}, 3)
                 .box("target", {o + 11, o - 1}, {o + 12, o + 1}, visible ? above(5) : 5)
                 .scene(),
               cell,
               {"wall"}};
    if (visible) c.visible.emplace_back("target");
    out.push_back(std::move(c));
  }
  for (bool const visible : {false, true}) {
    double const last = visible ? below(o + 3.5) : o + 3.5;
    HardCase c{"far offset",
               (visible ? "three corners an ulp off a line at " : "three corners on a line at ") + where,
               "As near zero: lines pass iff the sum of the outer corners is less than twice the middle one.",
               Stage()
                 .box("first", {o + 3, o - 100}, {o + 4, o + 1.5}, 50)
                 .box("second", {o + 4, o + 2.5}, {o + 5, o + 100}, 50)
                 .box("third", {o + 7, o - 100}, {o + 8, last}, 50)
                 .box("target", {o + 10, o + 2}, {o + 11, o + 8}, 3)
                 .scene(),
               cell,
               {"first", "second", "third"}};
    if (visible) c.visible.emplace_back("target");
    out.push_back(std::move(c));
  }
}

}  // namespace

Cases far_offsets()
{
  Cases out;
  add(out, 1e6, "10^6");
  add(out, 1e7, "10^7");
  add(out, 1e8, "10^8");
  return out;
}

}  // namespace visibility::hard_cases
