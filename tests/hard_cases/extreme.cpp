#include "hard_case.hpp"

namespace visibility::hard_cases {

namespace {

Box scaled(double s, Box const& b)
{
  return {{s * b.min.x, s * b.min.y, s * b.min.z}, {s * b.max.x, s * b.max.y, s * b.max.z}};
}

/// The case "roof on the line over a wall" in units of s, a power of two, by which products are exact here.
HardCase roof(double s, std::string const& unit, double top, bool visible)
{
  HardCase c{"extreme numbers",
             (visible ? "a roof above the line over a wall, unit " : "a roof on the line over a wall, unit ") + unit,
             "Scaling by a power of two changes nothing: lines over the wall pass x = 11 units above z = 5 units.",
             Stage()
               .box("wall", scaled(s, Box{{3, -100, 0}, {4, 100, 3}}))
               .box("target", scaled(s, Box{{11, -1, 0}, {12, 1, top}}))
               .scene(),
             ViewCell(scaled(s, Box{{-1, -1, 1}, {1, 1, 2}})),
             {"wall"}};
  if (visible) c.visible.emplace_back("target");
  return c;
}

HardCase long_walls(std::string const& name, double low, double high)
{
  HardCase c{"extreme numbers",
             name,
             "Ends that far away do not matter to what passes between the walls.",
             Stage()
               .box("north", {3, high}, {4, 1e300}, 50)
               .box("south", {3, -1e300}, {4, low}, 50)
               .box("target", {10, -1}, {11, 1}, 3)
               .scene(),
             ViewCell(Box{{-1, -1, 1}, {1, 1, 2}}),
             {"north", "south"}};
  if (low < high) {
    c.visible.emplace_back("target");
    c.sight_lines.push_back({"target", {0, middle(low, high), 1.5}, {10, middle(low, high), 1.5}});
  }
  return c;
}

}  // namespace

Cases extreme()
{
  Cases out;
  for (auto const& [s, unit] : {std::pair(0x1p-1070, "2^-1070"), std::pair(0x1p-600, "2^-600"),
                                std::pair(0x1p600, "2^600"), std::pair(0x1p1000, "2^1000")}) {
    out.push_back(roof(s, unit, 5, false));
    out.push_back(roof(s, unit, 5.0625, true));
  }
  out.push_back(long_walls("abutting walls 10^300 long", .5, .5));
  out.push_back(long_walls("a slit of one ulp between walls 10^300 long", .5, above(.5)));
  return out;
}

}  // namespace visibility::hard_cases
