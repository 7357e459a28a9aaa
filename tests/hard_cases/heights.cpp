#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

Scene two_rows(double first, double second)
{
  return Stage().box("first", {3, -100}, {4, 100}, first).box("second", {6, -1}, {7, 1}, second).scene();
}

/// Ten blocks side by side, one behind the other.
Scene terrace(double sixth)
{
  Stage s;
  for (int i = 0; i < 10; ++i) s.box("row " + std::to_string(i), {3. + i, -100}, {4. + i, 100}, i == 5 ? sixth : 2);
  return s.scene();
}

}  // namespace

Cases heights()
{
  Cases out;
  ViewCell const cell(Box{{-1, -1, 1}, {1, 1, 2}});
  double const up = above(2);
  out.push_back({"equal heights",
                 "two rows of equal height, above the cell",
                 "Lines over the first row rise, and are above the second when they come to it.",
                 two_rows(3, 3),
                 cell,
                 {"first"}});
  out.push_back({"equal heights",
                 "two rows as high as the cell",
                 "Lines from z < 2 that pass over z = 2 rise.",
                 two_rows(2, 2),
                 cell,
                 {"first"}});
  out.push_back({"equal heights",
                 "two rows one ulp below the cell's top",
                 "A line that falls by half an ulp passes over the first roof and ends on the second.",
                 two_rows(2, 2),
                 ViewCell(Box{{-1, -1, 1}, {1, 1, up}}),
                 {"first", "second"},
                 {{"second", {0, 0, middle(2, up)}, {6.5, 0, 2}}}});
  out.push_back(
    {"equal heights", "a second row one ulp lower", "It is hidden by more.", two_rows(2, below(2)), cell, {"first"}});
  RationalNumber const part = RationalNumber(up - 2) / 64;
  out.push_back({"equal heights",
                 "a second row one ulp higher",
                 "A line that rises slowly enough passes over the first row and ends in the last ulp of the second.",
                 two_rows(2, up),
                 cell,
                 {"first", "second"},
                 {{"second", {0, 0, 2 - part}, {6, 0, 2 + 2 * part}}}});
  out.push_back({"equal heights",
                 "a terrace of ten roofs in the plane of the cell's top",
                 "The plane is not in the open cell: only the front of the first block is seen.",
                 terrace(2),
                 cell,
                 {"row 0"}});
  out.push_back({"equal heights",
                 "a terrace with one roof an ulp higher",
                 "The rise shows above the roofs before it, that lie in the plane of the cell's top.",
                 terrace(up),
                 cell,
                 {"row 0", "row 5"},
                 {{"row 5", {0, 0, 2 - part}, {8, 0, 2 + 3 * part}}}});
  return out;
}

}  // namespace visibility::hard_cases
