#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

HardCase make(std::string const& name, std::string const& why, Stage& s, std::vector<std::string> visible)
{
  return {"slivers", name, why, s.scene(), ViewCell(Box{{-1, -1, 1}, {1, 1, 2}}), std::move(visible)};
}

}  // namespace

Cases slivers()
{
  Cases out;
  Box const target{{10, -1, 0}, {11, 1, 3}};
  std::string const thin = "However thin, it is a closed set that every line to the target crosses.";
  out.push_back(make("a wall one ulp thick", thin,
                     Stage().box("wall", {3, -100}, {above(3), 100}, 50).box("target", target), {"wall"}));
  out.push_back(make("a wall without thickness", thin,
                     Stage().box("wall", {3, -100}, {3, 100}, 50).box("target", target), {"wall"}));
  out.push_back(make("a prism over a triangle one ulp wide", thin,
                     Stage().prism("wall", {{3, -100}, {above(3), 0}, {3, 100}}, 50).box("target", target), {"wall"}));
  out.push_back(make("a curtain of long triangles", thin,
                     Stage()
                       .triangle("wall", {3, -100, 0}, {3, 100, 50}, {3, -100, 50})
                       .triangle("wall", {3, -100, 0}, {3, 100, 0}, {3, 100, 50})
                       .box("target", target),
                     {"wall"}));
  out.push_back(make("a target one ulp thick", "Its front is as large as any.",
                     Stage().box("target", {10, -1}, {above(10), 1}, 3), {"target"}));
  out.push_back(make("a target one ulp wide", "Its front is one ulp wide: that is not nothing.",
                     Stage().box("target", {10, .5}, {11, above(.5)}, 3), {"target"}));
  out.push_back(make("a target without thickness", "It is a rectangle, seen from the front.",
                     Stage().box("target", {10, -1}, {10, 1}, 3), {"target"}));
  out.push_back(make("a triangle without area before the target",
                     "A segment hides next to nothing; and the box far off is what makes its object visible.",
                     Stage()
                       .triangle("post", {3, 0, 0}, {3, 0, 25}, {3, 0, 50})
                       .box("post", {-20, -1}, {-19, 1}, 3)
                       .box("target", target),
                     {"post", "target"}));
  return out;
}

}  // namespace visibility::hard_cases
