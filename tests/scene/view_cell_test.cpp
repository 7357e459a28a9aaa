#include "support/catch.hpp"
#include "support/random.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient3d.hpp"
#include "visibility/scene/view_cell.hpp"

#include <algorithm>
#include <limits>
#include <optional>

using namespace visibility;
using test::Random;

TEST_CASE("view cell: a hull keeps extreme points bit for bit and knows when it is a box", "[scene]")
{
  std::vector<Point3d> points;
  for (auto const& c : Box{{0.1, 0.2, 0.3}, {1.7, 2.9, 3.1}}.corners()) points.push_back(c);
  points.push_back({1, 1, 1});
  ViewCell const cell = ViewCell::hull(points);
  REQUIRE(cell.is_box());
  REQUIRE(cell.vertices().size() == 8);
  points.push_back({9, 1, 1});
  REQUIRE_FALSE(ViewCell::hull(points).is_box());
}

TEST_CASE("view cell: cells without interior are refused", "[scene][degenerate]")
{
  REQUIRE_THROWS_AS(ViewCell(Box{{0, 0, 0}, {1, 1, 0}}), std::invalid_argument);
  REQUIRE_THROWS_AS(ViewCell(Box{{0, 0, 0}, {-1, 1, 1}}), std::invalid_argument);
  REQUIRE_THROWS_AS(ViewCell(Box{{0, 0, 0}, {1, 1, std::numeric_limits<double>::infinity()}}), std::invalid_argument);
  REQUIRE_THROWS_AS(ViewCell(Box{{std::nan(""), 0, 0}, {1, 1, 1}}), std::invalid_argument);
  std::vector<Point3d> const flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}};
  REQUIRE_THROWS_AS(ViewCell::hull(flat), std::invalid_argument);
  std::vector<Point3d> const same(5, Point3d{1, 2, 3});
  REQUIRE_THROWS_AS(ViewCell::hull(same), std::invalid_argument);
}

TEST_CASE("view cell: what is certainly disjoint has no point in the cell", "[scene][conservative]")
{
  Random random(5);
  int disjoint = 0;
  for (int trial = 0; trial < 2'000; ++trial) {
    std::vector<Point3d> points;
    for (int i = 0; i < 7; ++i) points.push_back(random.grid_point(0, 4));
    std::optional<ViewCell> cell;
    try {
      cell = ViewCell::hull(points);
    } catch (std::invalid_argument const&) {
      continue;
    }
    Box box;
    box.extend(random.grid_point(-1, 5));
    box.extend(random.grid_point(-1, 5));
    if (!certainly_disjoint(*cell, box)) continue;
    ++disjoint;
    for (auto const& v : cell->vertices()) REQUIRE_FALSE(contains(box, v));
    // No vertex of the box lies in the cell, nor does the box's centre.
    auto const inside = [&](Point3d const& p) {
      return std::ranges::none_of(cell->shape().facets, [&](auto const& f) {
        auto const& x = cell->shape().vertices;
        return is_positive(orient3d<Rational>(x[f.vertices[0]], x[f.vertices[1]], x[f.vertices[2]], p));
      });
    };
    for (auto const& c : box.corners()) REQUIRE_FALSE(inside(c));
    REQUIRE_FALSE(inside({(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, (box.min.z + box.max.z) / 2}));
  }
  REQUIRE(disjoint > 100);
}
