#include "segment_checks.hpp"
#include "visibility/geometry/segment_box.hpp"
#include "visibility/geometry/segment_polyhedron.hpp"
#include "visibility/geometry/segment_prism.hpp"
#include "visibility/geometry/segment_triangle.hpp"

using namespace visibility;
using namespace visibility::test;

TEST_CASE("bodies: one solid as box, prism and polyhedron meets the same segments", "[geometry][agreement][degenerate]")
{
  Random random(67);
  int met = 0, missed = 0;
  for (double const scale : scales)
    for (int i = 0; i < trials(100); ++i) {
      Box box;
      while (!box.has_interior()) {
        box = {};
        box.extend(scaled(even_point(random, 6), scale));
        box.extend(scaled(even_point(random, 6), scale));
      }
      ConvexPrism const prism{
        {{box.min.x, box.min.y}, {box.max.x, box.min.y}, {box.max.x, box.max.y}, {box.min.x, box.max.y}},
        box.min.z,
        box.max.z};
      ConvexPolyhedron const polyhedron = ConvexPolyhedron::from_box(box);
      for (int k = 0; k < 20; ++k) {
        Point3d const p = special_point(landmarks(box), random, scale),
                      q = special_point(landmarks(box), random, scale);
        if (p == q || !is_finite(p) || !is_finite(q)) continue;
        CAPTURE(scale, i, k);
        bool const closed = segment_meets<Filtered>(box, p, q),
                   half_open = segment_meets<Filtered, End::excluded>(box, p, q);
        REQUIRE(segment_meets<Filtered>(prism, p, q) == closed);
        REQUIRE(segment_meets<Filtered>(polyhedron, p, q) == closed);
        REQUIRE(segment_meets<Filtered, End::excluded>(prism, p, q) == half_open);
        REQUIRE(segment_meets<Filtered, End::excluded>(polyhedron, p, q) == half_open);
        closed ? ++met : ++missed;
        // From outside, the body is met iff one of the triangles of its boundary is.
        if (contains(box, p)) continue;
        REQUIRE(half_open == std::ranges::any_of(polyhedron.facets, [&](auto const& f) {
                  auto const& v = polyhedron.vertices;
                  return segment_meets<Filtered, End::excluded>(v[f.vertices[0]], v[f.vertices[1]], v[f.vertices[2]], p,
                                                                q);
                }));
      }
    }
  REQUIRE(met > 100);
  REQUIRE(missed > 100);
}
