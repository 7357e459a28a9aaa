#include "segment_checks.hpp"
#include "visibility/geometry/segment_box.hpp"

using namespace visibility;
using namespace visibility::test;

TEST_CASE("segment_box: agrees with exact clipping, closed and half-open, at all scales, flat boxes too",
          "[geometry][oracle][degenerate]")
{
  Random random(60);
  Reached reached;
  for (double const scale : scales)
    for (int i = 0; i < trials(100); ++i) {
      Box box;
      box.extend(scaled(even_point(random, 6), scale));
      if (!random.chance(0.05)) box.extend(scaled(even_point(random, 6), scale));
      if (random.chance(0.2)) box.max.z = box.min.z;
      CAPTURE(i, box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z);
      check_segments(box, landmarks(box), random, scale, 20, reached);
    }
  require_reached(reached);
}

TEST_CASE("segment_box: a segment that stops at the box touches it with its end only", "[geometry][degenerate]")
{
  Box const box{{0, 0, 0}, {1, 1, 1}};
  auto const closed = [&](Point3d p, Point3d q) { return segment_meets<Filtered>(box, p, q); };
  auto const half_open = [&](Point3d p, Point3d q) { return segment_meets<Filtered, End::excluded>(box, p, q); };
  for (Point3d const end : {Point3d{0, 0.5, 0.5}, Point3d{0, 0, 0.5}, Point3d{0, 0, 0}}) {  // face, edge, corner
    CHECK(closed({-1, -1, -1}, end));
    CHECK_FALSE(half_open({-1, -1, -1}, end));
    CHECK(half_open(end, {-1, -1, -1}));  // the start belongs to the segment
  }
  CHECK(half_open({0, 0, -1}, {0, 0, 0.5}));  // along an edge
  CHECK_FALSE(half_open({0, 0, -1}, {0, 0, 0}));
  CHECK(half_open({0, -1, 0.5}, {0, 0.5, 0.5}));  // in a face's plane
  CHECK(half_open({-1, 1, 0.5}, {1, -1, 0.5}));   // across an edge
  CHECK_FALSE(closed({-1, 1, 0.5}, {1, std::nextafter(-1, -2), 0.5}));
}
