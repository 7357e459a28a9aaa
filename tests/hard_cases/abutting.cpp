#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

ViewCell cell() { return ViewCell(Box{{-1, -1, 1}, {1, 1, 2}}); }
ViewCell upper_cell() { return ViewCell(Box{{-1, 0, 1}, {1, 2, 2}}); }

Stage& with_target(Stage& s) { return s.box("target", {10, -1}, {11, 1}, 3); }

HardCase wall(std::string const& name, std::string const& why, Stage& s, std::vector<std::string> visible)
{
  return {"abutting", name, why, with_target(s).scene(), cell(), std::move(visible)};
}

}  // namespace

Cases abutting()
{
  Cases out;
  std::string const closed = "Occluders are closed: the line that slips between them touches both. ";
  out.push_back(wall("boxes that share a face", closed + "So nothing is seen through their common face.",
                     Stage().box("north", {3, 0}, {4, 100}, 50).box("south", {3, -100}, {4, 0}, 50),
                     {"north", "south"}));
  out.push_back(
    {"abutting",
     "boxes that share a vertical edge",
     closed + "Every line past the edge x = 4, y = 1 from left to right goes through one of the boxes or the edge.",
     Stage()
       .box("south", {3, -100}, {4, 1}, 50)
       .box("north", {4, 1}, {5, 100}, 50)
       .box("target", {10, -5}, {11, 3}, 3)
       .scene(),
     upper_cell(),
     {"north", "south"}});
  double const y = above(1);
  out.push_back({"abutting",
                 "boxes whose edges miss each other by an ulp",
                 "The level line between y = 1 and the next double passes above one box and below the other.",
                 Stage()
                   .box("south", {3, -100}, {4, 1}, 50)
                   .box("north", {4, y}, {5, 100}, 50)
                   .box("target", {10, -5}, {11, 3}, 3)
                   .scene(),
                 upper_cell(),
                 {"north", "south", "target"},
                 {{"target", {0, middle(1, y), 1.5}, {10, middle(1, y), 1.5}}}});
  out.push_back(wall("prisms that share a slanting side", closed + "The common side has the same ends in both.",
                     Stage()
                       .prism("south", {{3, -100}, {6, -100}, {6, 1}, {3, 0}}, 50)
                       .prism("north", {{3, 0}, {6, 1}, {6, 100}, {3, 100}}, 50),
                     {"north", "south"}));
  double const third = 1. / 3;  // below 1/3
  auto const junction = [](double t) {
    return Stage()
      .prism("south", {{3, -100}, {6, -100}, {6, 1}, {3, 0}}, 50)
      .prism("west", {{3, 0}, {4, t}, {4, 100}, {3, 100}}, 50)
      .prism("east", {{4, t}, {6, 1}, {6, 100}, {4, 100}}, 50);
  };
  auto overlap = junction(third);
  out.push_back(wall("T-junction whose vertex is rounded into the neighbour",
                     "1/3 rounds down: the vertex (4, 1/3) lies inside the prism to the south; all overlap or touch, "
                     "and the prism to the east is behind that to the west.",
                     overlap, {"south", "west"}));
  auto pocket = junction(above(third));
  out.push_back(
    wall("T-junction whose vertex is rounded off the neighbour",
         "The next double is above 1/3 and leaves a pocket with corners (3, 0), (4, 1/3), (6, 1); but it is "
         "closed at both ends, where the prisms touch, so no line comes through.",
         pocket, {"south", "west"}));
  out.push_back(wall("curtains that share a vertical edge", closed + "Triangles are closed, too.",
                     Stage().curtain("north", {3, 0, 50}, {3, 100, 50}).curtain("south", {3, -100, 50}, {3, 0, 50}),
                     {"north", "south"}));
  out.push_back(wall("curtains that meet at a bend", closed + "No line passes between them at (4, 0).",
                     Stage().curtain("north", {4, 0, 50}, {3, 100, 50}).curtain("south", {3, -100, 50}, {4, 0, 50}),
                     {"north", "south"}));
  out.push_back(wall(
    "a wall of two storeys", "The storeys share the face z = 1.5, at eye level, and both are closed.",
    Stage().box("wall", Box{{3, -100, 0}, {4, 100, 1.5}}).box("wall", Box{{3, -100, 1.5}, {4, 100, 50}}), {"wall"}));
  Stage posts;
  for (int k = -500; k < 500; ++k) posts.box("wall", {3, k / 10.}, {4, (k + 1) / 10.}, 50);
  out.push_back(wall("a wall of a thousand posts",
                     "Posts from k / 10 to (k + 1) / 10, as rounded: each begins exactly where the one before ends.",
                     posts, {"wall"}));
  return out;
}

}  // namespace visibility::hard_cases
