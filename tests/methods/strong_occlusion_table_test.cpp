// The counts of table 2 in [CohenOr98]: boxes of the city that have a strong occluder, by cell size. Prints a table
// beside the paper's numbers: test_methods "[table]". Street width, heights of cells and where they stand are not in
// the paper, so agreement is a matter of trend.

#include "support/catch.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/generators.hpp"

#include <iostream>

using namespace visibility;

namespace {

struct Row {
  double side;
  int paper;
};

std::size_t hidden_boxes(PreparedScene const& scene, ViewCell const& cell)
{
  strong_occlusion::OccluderSearch<Filtered> search(scene, cell);
  std::size_t hidden = 0;
  for (auto const& box : scene.scene().boxes) {
    auto const corners = box.corners();
    std::vector<Point3d> target(corners.begin(), corners.end());
    hidden += certainly_disjoint(cell, box) && search.find(target).has_value();
  }
  return hidden;
}

}  // namespace

TEST_CASE("strong occlusion: smaller cells see fewer boxes of the paper's city", "[methods][table]")
{
  Scene const scene = generate("city");
  PreparedScene const prepared(scene);
  REQUIRE(scene.boxes.size() == 3324);
  std::size_t last = 0;
  for (Row const row : {Row{200, 11}, Row{150, 39}, Row{100, 337}, Row{90, 1456}, Row{80, 2120}, Row{70, 2521},
                        Row{60, 2778}, Row{50, 2918}, Row{40, 2994}, Row{30, 3052}, Row{20, 3088}, Row{10, 3116}}) {
    double const h = row.side / 2;
    auto const hidden = hidden_boxes(prepared, ViewCell(Box{{-h, -h, 0}, {h, h, 50}}));
    std::cout << "cell " << row.side << ": " << hidden << " of 3324 boxes strongly occluded, " << row.paper
              << " in the paper\n";
    REQUIRE(hidden >= last);
    last = hidden;
  }
}
