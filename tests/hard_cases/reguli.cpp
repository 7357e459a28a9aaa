#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

/// All edges lie in one family of lines of the paraboloid z = x y; the other family are lines that touch all of them.
HardCase paraboloid(std::string const& name, std::string const& why, double cell_low, double target_high, double depth,
                    bool visible)
{
  Stage s;
  double const bottom = -1000;
  for (auto const& [wall, c] : {std::pair("first", 2.), std::pair("second", 4.), std::pair("third", 6.)})
    s.curtain(wall, {c, -64, -64 * c}, {c, 64, 64 * c}, bottom);
  double const target_low = std::floor(target_high) - 1;
  s.curtain("target", {8, target_low, 8 * target_low}, {8, target_high, 8 * target_high}, bottom);
  HardCase out{
    "closed reguli",
    name,
    "Walls x = 2, 4, 6 and the target x = 8 have the tops z = x y, the cell, of depth D before x = 0, the top z = 0. "
    "A line from (-d, y0) to (8, y8), at best from edge to edge, has z - c y = (8 - c) (y8 (c + d) - c y0) / (8 + d) "
    "at x = c. "
    "So it passes all walls iff y8 (6 + d) > 6 y0. " +
      why,
    s.scene(),
    ViewCell(Box{{-depth, cell_low, -1}, {0, cell_low + 1, 0}}),
    {"first", "second", "third"}};
  if (visible) out.visible.emplace_back("target");
  return out;
}

}  // namespace

Cases reguli()
{
  Cases out;
  auto open = paraboloid("a regulus that lines cross from below", "Here y0 < 1 and y8 > 2.", 0, 3, 2, true);
  open.sight_lines.push_back({"target", {-1, .5, RationalNumber(-1) / 64}, {8, 2.5, 20 - RationalNumber(1) / 64}});
  out.push_back(std::move(open));
  out.push_back(paraboloid("a regulus seen from its other side", "Here y8 * 8 < 8 and 6 y0 > 12.", 2, 1, 2, false));
  out.push_back(paraboloid("a regulus, touched by one line",
                           "Here y8 * 8 <= 24 and 6 y0 >= 24: equal for one line only, which touches.", 4, 3, 2,
                           false));
  out.push_back(paraboloid("a regulus, an ulp open", "Here y8 may exceed 3 by an ulp.", 4, above(3), 2, true));
  out.push_back(paraboloid("a regulus, an ulp closed", "Here y0 exceeds 4 by an ulp.", above(4), 3, 2, false));
  out.push_back(paraboloid("all lines of a regulus",
                           "Lines with y0 = y8, d = 0 touch all edges, others with y8 > y0 pass above.", 0, 1, 2,
                           true));
  out.push_back(paraboloid("all lines of a regulus, seen from next to nothing behind it",
                           "With y8 <= 1 and y0 >= 1 lines pass only from d > 0, that is from a cell 2^-40 deep.", 1, 1,
                           0x1p-40, true));
  return out;
}

}  // namespace visibility::hard_cases
