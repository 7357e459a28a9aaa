#include "segment_checks.hpp"
#include "visibility/geometry/segment_triangle.hpp"

using namespace visibility;
using namespace visibility::test;

TEST_CASE("segment_triangle: agrees with exact clipping, closed and half-open, degenerate triangles too",
          "[geometry][oracle][degenerate]")
{
  Random random(63);
  Reached reached;
  for (double const scale : scales)
    for (int i = 0; i < trials(150); ++i) {
      Triangle t;
      for (auto& v : t.vertices) v = even_point(random, random.chance(0.3) ? 1 : 6);
      int const kind = random.below(6);
      auto const& [a, b, c] = t.vertices;
      if (kind == 0) t.vertices[2] = {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)};  // a segment
      if (kind == 1) t.vertices[static_cast<std::size_t>(random.below(3))] = a;                  // a repeated vertex
      if (kind == 2) t.vertices[1] = t.vertices[2] = a;                                          // a point
      if (kind == 3) t.vertices[0].z = t.vertices[1].z = t.vertices[2].z;
      for (auto& v : t.vertices) v = scaled(v, scale);
      CAPTURE(i, kind, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
      check_segments(t, landmarks(t), random, scale, 15, reached);
      // In the triangle's own plane, where most of the branches are.
      for (int k = 0; k < 5; ++k) {
        auto const on_plane = [&] {
          double const u = 0.5 * random.between(-3, 3), v = 0.5 * random.between(-3, 3), w = 1 - u - v;
          return Point3d{u * a.x + v * b.x + w * c.x, u * a.y + v * b.y + w * c.y, u * a.z + v * b.z + w * c.z};
        };
        Point3d const p = on_plane(), q = on_plane();
        if (p == q || !is_finite(p) || !is_finite(q)) continue;
        CAPTURE(p.x, p.y, p.z, q.x, q.y, q.z);
        for (End const end : {End::included, End::excluded}) {
          bool const met = oracle::meets(t, p, q, end);
          REQUIRE((end == End::included ? segment_meets<Filtered>(t, p, q)
                                        : segment_meets<Filtered, End::excluded>(t, p, q)) == met);
        }
      }
    }
  require_reached(reached);
}

TEST_CASE("segment_triangle: the order of the vertices does not matter", "[geometry][law]")
{
  Random random(64);
  for (int i = 0; i < trials(2000); ++i) {
    Point3d const a = random.grid_point(0, 3), b = random.grid_point(0, 3), c = random.grid_point(0, 3);
    Point3d const p = random.grid_point(0, 3), q = random.grid_point(0, 3);
    if (p == q) continue;
    bool const met = segment_meets<Filtered, End::excluded>(a, b, c, p, q);
    REQUIRE(segment_meets<Filtered, End::excluded>(b, c, a, p, q) == met);
    REQUIRE(segment_meets<Filtered, End::excluded>(b, a, c, p, q) == met);
    REQUIRE(segment_meets<Filtered, End::excluded>(c, b, a, p, q) == met);
  }
}
