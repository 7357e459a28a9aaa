#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

HardCase roof(std::string const& name, std::string const& why, ViewCell const& cell, bool visible)
{
  HardCase c{
    "cells",
    name,
    why,
    Stage().box("wall", {3, -100}, {4, 100}, 3).box("target", {11, -1}, {12, 1}, visible ? above(5) : 5).scene(),
    cell,
    {"wall"}};
  if (visible) c.visible.emplace_back("target");
  return c;
}

}  // namespace

Cases cells()
{
  Cases out;
  ViewCell const cell(Box{{-1, -1, 1}, {1, 1, 2}});
  out.push_back({"cells",
                 "a box that touches the cell, and one behind it",
                 "The first meets the closed cell; every line to the second passes it.",
                 Stage().box("touching", {1, -100}, {2, 100}, 50).box("behind", {2, -1}, {3, 1}, 3).scene(),
                 cell,
                 {"touching"}});
  out.push_back(
    {"cells",
     "a curtain on the side of the cell, a box an ulp behind it",
     "The curtain meets the closed cell, and every line from the open cell to the box crosses it.",
     Stage().curtain("curtain", {1, -100, 50}, {1, 100, 50}).box("behind", {above(1), -1}, {2, 1}, 3).scene(),
     cell,
     {"curtain"}});
  out.push_back({"cells",
                 "a box that touches the cell in one point",
                 "They share the corner (1, 1, 1): it meets the closed cell. Besides, it hides what is behind it.",
                 Stage().box("touching", Box{{1, 1, 0}, {3, 3, 1}}).box("behind", {1.5, 1.5}, {2, 2}, .5).scene(),
                 cell,
                 {"touching"}});
  out.push_back({"cells",
                 "a cell that stands on a roof",
                 "The roof is the cell's floor: they share points.",
                 Stage().box("house", {-1, -1}, {1, 1}, 1).box("cellar", {-.5, -.5}, {.5, .5}, .5).scene(),
                 cell,
                 {"house"}});
  out.push_back({"cells",
                 "a cell above everything",
                 "Roofs are seen from above, but not the box inside another, nor the one right behind a tower: lines "
                 "from the cell over "
                 "(4, 50) come to z = 1 beyond x = 6.",
                 Stage()
                   .box("high", {3, -1}, {4, 1}, 50)
                   .box("low", {15, -1}, {16, 1}, 1)
                   .box("shaded", {5, -1}, {6, 1}, 1)
                   .box("inside", {3.25, -.5}, {3.75, .5}, 40)
                   .scene(),
                 ViewCell(Box{{-1, -1, 100}, {1, 1, 101}}),
                 {"high", "low"}});
  std::string const edge =
    "Only the far top edge of the cell counts, x = -1, z = 2, and lines from it are not below z = 5 at x = 11.";
  out.push_back(
    roof("a cell one ulp high, roof on the line", edge, ViewCell(Box{{-1, -1, below(2)}, {1, 1, 2}}), false));
  out.push_back(
    roof("a cell one ulp high, roof above the line", edge, ViewCell(Box{{-1, -1, below(2)}, {1, 1, 2}}), true));
  out.push_back(
    roof("a cell one ulp deep, roof on the line", edge, ViewCell(Box{{-1, -1, 1}, {above(-1), 1, 2}}), false));
  out.push_back(
    roof("a cell one ulp deep, roof above the line", edge, ViewCell(Box{{-1, -1, 1}, {above(-1), 1, 2}}), true));
  std::vector<Point3d> const tip{{-1, 0, 2}, {1, -1, 1}, {1, 1, 1}, {1, 0, 1.5}};
  std::string const apex = "Of this tetrahedron only the tip (-1, 0, 2) comes near the line.";
  out.push_back(roof("a cell with a tip, roof on the line from it", apex, ViewCell::hull(tip), false));
  out.push_back(roof("a cell with a tip, roof above the line from it", apex, ViewCell::hull(tip), true));
  out.push_back(
    {"cells",
     "a box inside the cell",
     "It meets the cell; from beside it the target is seen.",
     Stage().box("inside", Box{{-.5, -.5, 1.25}, {.5, .5, 1.75}}).box("target", {10, -1}, {11, 1}, 3).scene(),
     cell,
     {"inside", "target"},
     {{"target", {.75, 0, 1.5}, {10, 0, 1.5}}},
     false});
  return out;
}

}  // namespace visibility::hard_cases
