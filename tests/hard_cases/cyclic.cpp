#include "hard_case.hpp"

namespace visibility::hard_cases {

Cases cyclic()
{
  Cases out;
  ViewCell const cell(Box{{-1, -1, 1}, {1, 1, 2}});
  out.push_back({"cyclic",
                 "a closed pinwheel around the cell",
                 "Each wall ends at the side of the next and touches it: closed sets leave no way out.",
                 Stage()
                   .box("east", {4, -5}, {5, 4}, 50)
                   .box("north", {-4, 4}, {5, 5}, 50)
                   .box("south", {-5, -5}, {4, -4}, 50)
                   .box("west", {-5, -4}, {-4, 5}, 50)
                   .box("target", {10, 5}, {11, 7}, 3)
                   .scene(),
                 cell,
                 {"east", "north", "south", "west"}});
  out.push_back({"cyclic",
                 "an open pinwheel around the cell",
                 "Walls overlap, but leave openings one wide: y = 3 + 1/16 + 7/16 (x - 4) passes above the one to the "
                 "east and below the one to the north.",
                 Stage()
                   .box("east", {4, -6}, {5, 3}, 50)
                   .box("north", {-4, 4}, {6, 5}, 50)
                   .box("south", {-6, -5}, {4, -4}, 50)
                   .box("west", {-5, -3}, {-4, 6}, 50)
                   .box("target", {10, 5}, {11, 7}, 3)
                   .scene(),
                 cell,
                 {"east", "north", "south", "target", "west"},
                 {{"target", {-.875, .9296875, 1.5}, {10, 5.6875, 1.5}}}});
  out.push_back(
    {"cyclic",
     "two towers, each before the other",
     "Seen from the left end of a long cell the left tower hides the right one, from the right end the right "
     "one hides the left. No order is strict, and both are seen.",
     Stage().box("left", {-4, .5}, {-3, 10}, 50).box("right", {3, .5}, {4, 10}, 50).scene(),
     ViewCell(Box{{-10, -1, 1}, {10, 0, 2}}),
     {"left", "right"}});
  out.push_back({"cyclic",
                 "two towers, each before the other, and what they hide together",
                 "The wall between the towers closes the view: whatever is behind all three is hidden, although none "
                 "hides it alone.",
                 Stage()
                   .box("left", {-100, .5}, {-3, 10}, 50)
                   .box("right", {3, .5}, {100, 10}, 50)
                   .box("wall", {-5, 11}, {5, 12}, 50)
                   .box("target", {-4, 13}, {4, 14}, 3)
                   .scene(),
                 ViewCell(Box{{-1, -1, 1}, {1, 0, 2}}),
                 {"left", "right", "wall"}});
  return out;
}

}  // namespace visibility::hard_cases
