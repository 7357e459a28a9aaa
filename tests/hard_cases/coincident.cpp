#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

ViewCell cell() { return ViewCell(Box{{-1, -1, 1}, {1, 1, 2}}); }

HardCase make(std::string const& name, std::string const& why, Stage& s, std::vector<std::string> visible)
{
  return {"coincident", name, why, s.scene(), cell(), std::move(visible)};
}

}  // namespace

Cases coincident()
{
  Cases out;
  std::string const half_open =
    "A sight line ends before the face that it sees, so of coinciding faces neither hides the other. ";
  out.push_back(make("the same box twice", half_open + "Both are seen, and what is behind them is hidden.",
                     Stage()
                       .box("one", {3, -100}, {4, 100}, 50)
                       .box("other", {3, -100}, {4, 100}, 50)
                       .box("target", {10, -1}, {11, 1}, 3),
                     {"one", "other"}));
  out.push_back(make("a box inside a box", "Every line to the inner one passes the outer.",
                     Stage().box("inner", {3.25, -1}, {3.75, 1}, 40).box("outer", {3, -2}, {4, 2}, 50), {"outer"}));
  out.push_back(make("nested boxes with a common front", half_open,
                     Stage().box("inner", {3, -1}, {3.5, 1}, 40).box("outer", {3, -2}, {4, 2}, 50),
                     {"inner", "outer"}));
  out.push_back(make("nested boxes with a common back",
                     "The common face looks away from the cell: lines to it pass the outer box before.",
                     Stage().box("inner", {3.5, -1}, {4, 1}, 40).box("outer", {3, -2}, {4, 2}, 50), {"outer"}));
  out.push_back(make("nested boxes with a common side, edge-on",
                     "The common face y = 1 lies in the plane of the cell's side: from the open cell, y < 1, it is not "
                     "seen from outside.",
                     Stage().box("inner", {3.25, -1}, {3.75, 1}, 40).box("outer", {3, -2}, {4, 1}, 50), {"outer"}));
  out.push_back(make("a curtain on the front of a box", half_open,
                     Stage().box("box", {3, -2}, {4, 2}, 50).curtain("curtain", {3, -1, 40}, {3, 1, 40}),
                     {"box", "curtain"}));
  out.push_back(make("a curtain on the back of a box", "It is behind the box.",
                     Stage().box("box", {3, -2}, {4, 2}, 50).curtain("curtain", {4, -1, 40}, {4, 1, 40}), {"box"}));
  out.push_back(make("a curtain inside a box", "It is inside the box.",
                     Stage().box("box", {3, -2}, {4, 2}, 50).curtain("curtain", {3.5, -1, 40}, {3.5, 1, 40}), {"box"}));
  out.push_back(make("the same curtain twice", half_open,
                     Stage()
                       .curtain("one", {3, -100, 50}, {3, 100, 50})
                       .curtain("other", {3, -100, 50}, {3, 100, 50})
                       .box("target", {10, -1}, {11, 1}, 3),
                     {"one", "other"}));
  out.push_back(make("a box and its two halves", half_open + "All three have the front x = 3.",
                     Stage()
                       .box("north", {3, 0}, {4, 100}, 50)
                       .box("south", {3, -100}, {4, 0}, 50)
                       .box("whole", {3, -100}, {4, 100}, 50)
                       .box("target", {10, -1}, {11, 1}, 3),
                     {"north", "south", "whole"}));
  out.push_back(make("fronts in one plane, side by side", "Neither is before the other.",
                     Stage().box("north", {3, 1}, {4, 5}, 50).box("south", {3, -5}, {4, -1}, 5), {"north", "south"}));
  out.push_back(make("coplanar roofs below a cell, overlapping in plan",
                     half_open + "The roofs z = 1/2 coincide where the boxes overlap; the cell is above them.",
                     Stage().box("one", {3, -1}, {5, 1}, .5).box("other", {4, -2}, {6, 2}, .5), {"one", "other"}));
  return out;
}

}  // namespace visibility::hard_cases
