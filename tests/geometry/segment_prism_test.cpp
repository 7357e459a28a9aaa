#include "segment_checks.hpp"
#include "visibility/geometry/segment_prism.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

/// Counterclockwise convex polygons of even integers, some with vertices in the middle of an edge.
std::vector<Point2d> footprint(Random& random)
{
  static std::vector<std::vector<Point2d>> const shapes{
    {{0, 0}, {8, 0}, {2, 6}},
    {{-6, -4}, {6, -4}, {6, 8}, {-6, 8}},
    {{-6, 0}, {0, -6}, {6, 0}, {0, 6}},
    {{0, 0}, {4, 0}, {8, 0}, {8, 4}, {4, 8}, {0, 8}},
    {{-8, -2}, {-2, -8}, {4, -8}, {8, -2}, {8, 4}, {2, 8}, {-4, 8}, {-8, 4}},
    {{0, 0}, {2, 0}, {10, 10}, {8, 10}}};
  auto polygon = shapes[static_cast<std::size_t>(random.below(6))];
  double const dx = 2 * random.between(-4, 4), dy = 2 * random.between(-4, 4);
  for (auto& p : polygon) p = {p.x + dx, p.y + dy};
  return polygon;
}

}  // namespace

TEST_CASE("segment_prism: agrees with exact clipping, closed and half-open, at all scales",
          "[geometry][oracle][degenerate]")
{
  Random random(62);
  Reached reached;
  for (double const scale : scales)
    for (int i = 0; i < trials(80); ++i) {
      ConvexPrism prism{footprint(random), 2.0 * random.between(-6, 0) * scale, 2.0 * random.between(1, 6) * scale};
      for (auto& p : prism.footprint) p = {p.x * scale, p.y * scale};
      prism.validate();
      CAPTURE(i);
      check_segments(prism, landmarks(prism), random, scale, 15, reached);
    }
  require_reached(reached);
}

TEST_CASE("segment_prism: vertical segments", "[geometry][degenerate]")
{
  ConvexPrism const prism{{{0, 0}, {8, 0}, {2, 6}}, 0, 10};
  auto const half_open = [&](Point3d p, Point3d q) { return segment_meets<Filtered, End::excluded>(prism, p, q); };
  CHECK(half_open({3, 2, 20}, {3, 2, -5}));
  CHECK(half_open({2, 6, 20}, {2, 6, -5}));        // along an edge
  CHECK(half_open({4, 0, 20}, {4, 0, 9}));         // in a wall
  CHECK_FALSE(half_open({3, 2, 20}, {3, 2, 10}));  // stops on the roof
  CHECK_FALSE(half_open({2, 7, 20}, {2, 7, -5}));
  CHECK(half_open({3, 2, 10}, {3, 2, 20}));  // leaves from the roof
}
