#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

ViewCell cell() { return ViewCell(Box{{-1, -1, 1}, {1, 1, 2}}); }

HardCase roof(std::string const& name, double top, bool visible)
{
  HardCase c{
    "grazing",
    name,
    "Lines over the wall, x = 3 ... 4, height 3, are lowest behind it if they come from the far top edge, x = -1, "
    "z = 2, which the open cell has not: they pass x = 11 above z = 5. The target, x = 11 ... 12, is seen iff it "
    "is higher than 5.",
    Stage().box("wall", {3, -100}, {4, 100}, 3).box("target", {11, -1}, {12, 1}, top).scene(),
    cell(),
    {"wall"}};
  if (visible) c.visible.emplace_back("target");
  return c;
}

HardCase corner(std::string const& name, double side, bool visible)
{
  HardCase c{
    "grazing",
    name,
    "Lines past the wall's corner (3, 3) turn least to the left if they come from the cell's corner (-1, 1): they "
    "pass x = 11 at y > 7. The target, with a corner (11, y), is seen iff y > 7.",
    Stage().box("wall", {3, -100}, {4, 3}, 50).box("target", {11, 5}, {12, side}, 3).scene(),
    cell(),
    {"wall"}};
  if (visible) c.visible.emplace_back("target");
  return c;
}

}  // namespace

Cases grazing()
{
  Cases out;
  out.push_back(roof("roof one ulp below the line over a wall", below(5), false));
  out.push_back(roof("roof on the line over a wall", 5, false));
  out.push_back(roof("roof one ulp above the line over a wall", above(5), true));
  out.push_back(corner("corner one ulp short of the line past a wall", below(7), false));
  out.push_back(corner("corner on the line past a wall", 7, false));
  out.push_back(corner("corner one ulp beyond the line past a wall", above(7), true));
  out.push_back({"grazing",
                 "face in the plane of a side of the cell",
                 "The target's face y = 1 is seen slantingly from all of the cell, below the wall that ends at y = 1.",
                 Stage().box("wall", {3, 1}, {4, 100}, 50).box("target", {6, 1}, {7, 2}, 3).scene(),
                 cell(),
                 {"target", "wall"},
                 {{"target", {0, 0, 1.5}, {6.5, 1, 1.5}}}});
  out.push_back({"grazing",
                 "face that only the side of the cell sees, edge-on",
                 "Over the wall's corners (3, 1) and (4, 1) lines from the open cell, y < 1, rise, and are above the "
                 "target's face y = 1 when they come to it.",
                 Stage().box("wall", {3, -100}, {4, 1}, 50).box("target", {6, -2}, {7, 1}, 3).scene(),
                 cell(),
                 {"wall"}});
  double const y = above(1);
  out.push_back({"grazing",
                 "face that the last ulp of the cell sees",
                 "The same with a cell up to the next double: lines from y > 1 fall to y = 1 on the target.",
                 Stage().box("wall", {3, -100}, {4, 1}, 50).box("target", {6, -2}, {7, 1}, 3).scene(),
                 ViewCell(Box{{-1, -1, 1}, {1, y, 2}}),
                 {"target", "wall"},
                 {{"target", {0, middle(1, y), 1.5}, {6.5, 1, 1.5}}}});
  return out;
}

}  // namespace visibility::hard_cases
