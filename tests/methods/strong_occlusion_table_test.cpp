// The counts of table 2 in [CohenOr98]: boxes of the city that have a strong occluder, by cell size. Prints a table
// beside the paper's numbers: test_methods "[table]". Street width, heights of cells and where they stand are not in
// the paper, so agreement is a matter of trend.

#include "support/catch.hpp"

#include "visibility/methods/strong_occlusion/survey.hpp"
#include "visibility/scene/generators.hpp"

#include <iostream>

using namespace visibility;

namespace {

struct Row {
  double side;
  int paper;
};

}  // namespace

TEST_CASE("strong occlusion: smaller cells see fewer boxes of the paper's city", "[methods][table]")
{
  Scene const scene = generate("city");
  PreparedScene const prepared(scene);
  REQUIRE(scene.boxes.size() == 3324);
  std::uint64_t last = 0;
  for (Row const row : {Row{200, 11}, Row{150, 39}, Row{100, 337}, Row{90, 1456}, Row{80, 2120}, Row{70, 2521},
                        Row{60, 2778}, Row{50, 2918}, Row{40, 2994}, Row{30, 3052}, Row{20, 3088}, Row{10, 3116}}) {
    double const h = row.side / 2;
    auto const hidden =
      strong_occlusion::survey<Filtered>(prepared, ViewCell(Box{{-h, -h, 0}, {h, h, 50}}), {}).hidden_bodies;
    std::cout << "cell " << row.side << ": " << hidden << " of 3324 boxes strongly occluded, " << row.paper
              << " in the paper\n";
    REQUIRE(hidden >= last);
    last = hidden;
  }
}
