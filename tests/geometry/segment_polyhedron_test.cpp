#include "segment_checks.hpp"
#include "visibility/geometry/segment_polyhedron.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

std::vector<Point3d> some_points(Random& random)
{
  std::vector<Point3d> points;
  int const n = random.between(4, 10);
  for (int i = 0; i < n; ++i) points.push_back(even_point(random, 6));
  if (random.chance(0.5))  // faces with more than three vertices
    for (int i = 0; i < n; ++i)
      points.push_back({points[static_cast<std::size_t>(i)].x, points[static_cast<std::size_t>(i)].y, 14});
  return points;
}

}  // namespace

TEST_CASE("segment_polyhedron: agrees with exact clipping, closed and half-open, at all scales",
          "[geometry][oracle][degenerate]")
{
  Random random(61);
  Reached reached;
  for (double const scale : scales)
    for (int i = 0; i < trials(40); ++i) {
      auto points = some_points(random);
      for (auto& p : points) p = scaled(p, scale);
      ConvexPolyhedron body;
      try {
        body = ConvexPolyhedron::hull(points);
      } catch (std::invalid_argument const&) {
        continue;  // all points in one plane
      }
      CAPTURE(i);
      check_segments(body, landmarks(body), random, scale, 15, reached);
    }
  REQUIRE(reached.queries > trials(1500));
  require_reached(reached);
}

TEST_CASE("segment_polyhedron: inside, along a coplanar triangulated face, and through its diagonal",
          "[geometry][degenerate]")
{
  ConvexPolyhedron const cube = ConvexPolyhedron::from_box({{0, 0, 0}, {2, 2, 2}});
  auto const half_open = [&](Point3d p, Point3d q) { return segment_meets<Filtered, End::excluded>(cube, p, q); };
  CHECK(half_open({1, 1, 1}, {1.5, 1, 1}));    // no facet is touched
  CHECK(half_open({0.5, 1, 2}, {1.5, 1, 2}));  // in a face, across its diagonal
  CHECK(half_open({-1, -1, 2}, {3, 3, 2}));    // along a face's diagonal
  CHECK(half_open({1, 1, 3}, {1, 1, 1}));      // through the diagonal of the top
  CHECK_FALSE(half_open({1, 1, 3}, {1, 1, 2}));
  CHECK_FALSE(half_open({3, 1, 2}, {4, 1, 2}));  // in the plane of the top, beyond
  CHECK_FALSE(half_open({-1, 6, 2}, {6, -1, 2}));
  CHECK(half_open({0, 0, 5}, {0, 0, -5}));  // along a vertical edge
  CHECK(half_open({-1, 1, 2}, {1, 3, 2}));  // touches the top's edge at (0,2,2)
}
