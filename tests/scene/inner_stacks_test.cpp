#include "scene/inner_stacks.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <limits>

using namespace visibility;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

InnerBody prism(std::vector<Point2d> footprint, double bottom, double top, double floor = -infinity,
                bool needs_outside = true)
{
  return {ConvexPrism{std::move(footprint), bottom, top}, floor, needs_outside};
}

std::vector<Point2d> square(double r) { return {{-r, -r}, {r, -r}, {r, r}, {-r, r}}; }
std::vector<Point2d> diamond(double r) { return {{0, -r}, {r, 0}, {0, r}, {-r, 0}}; }

std::vector<InnerBody> stacked(std::vector<InnerBody> const& bodies) { return detail::stacks(bodies); }

}  // namespace

TEST_CASE("inner stacks: joined over the smaller footprint, as far as the heights touch", "[scene]")
{
  auto const out = stacked({prism(square(1), 4, 9), prism(square(2), 0, 4), prism(square(3), 8, 12)});
  REQUIRE(out.size() == 1);
  auto const& tower = std::get<ConvexPrism>(out[0].shape);
  CHECK(tower.footprint == square(1));
  CHECK(tower.bottom == 0);
  CHECK(tower.top == 12);
  CHECK(stacked({prism(square(1), std::nextafter(4.0, 5), 9), prism(square(2), 0, 4)}).empty());
}

TEST_CASE("inner stacks: the footprint must lie inside exactly, not only its box", "[scene][degenerate]")
{
  // The corner (2, 2) lies on the diamond of radius 4.
  CHECK(stacked({prism(square(2), 4, 8), prism(diamond(4), 0, 4)}).size() == 1);
  CHECK(stacked({prism(square(std::nextafter(2.0, 3)), 4, 8), prism(diamond(4), 0, 4)}).empty());
  CHECK(stacked({prism(square(2), 4, 8), prism(diamond(std::nextafter(4.0, 3)), 0, 4)}).empty());
}

TEST_CASE("inner stacks: serve the cells that all parts serve", "[scene]")
{
  // Equal footprints: from the storey with the lower floor nothing may be joined that serves fewer cells.
  auto const out = stacked({prism(square(1), 0, 4, 0), prism(square(1), 4, 8, 3)});
  REQUIRE(out.size() == 1);
  CHECK(out[0].floor == 3);
  CHECK(out[0].needs_outside);
  auto const mixed = stacked({prism(square(1), 0, 4, 0, false), prism(square(1), 4, 8, 0, true)});
  REQUIRE(mixed.size() == 1);
  CHECK(mixed[0].needs_outside);
  CHECK(stacked({prism(square(2), 0, 4, 0, true), prism(square(1), 4, 8, 0, false)}).empty());
}
