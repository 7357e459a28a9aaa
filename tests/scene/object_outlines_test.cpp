#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/scene/object_outlines.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;

namespace {

/// Many triangles over a disc, a grid, a segment, or a point, near the origin or far from it.
std::vector<Point3d> corner_points(Random& random)
{
  int const kind = random.below(5);
  Point2d const at = random.chance(0.5) ? Point2d{0, 0} : Point2d{random.uniform(-1e8, 1e8), random.uniform(-1e6, 1e6)};
  std::vector<Point3d> out;
  for (std::size_t i = 0; i < 3 * (ObjectOutlines::few_bodies + 1 + random.below(100)); ++i) {
    Point3d p = random.point(-1, 1);
    if (kind == 1) p = random.grid_point(-4, 4);
    if (kind == 2) p.y = 3 * p.x;
    if (kind == 3) p.x = p.y = 1;
    if (kind == 4) p.x = std::cos(20 * p.z), p.y = std::sin(20 * p.z);
    out.push_back({at.x + p.x, at.y + p.y, p.z});
  }
  return out;
}

}  // namespace

TEST_CASE("object outlines: all vertices are inside, and corners are strictly convex vertices", "[scene][law]")
{
  std::size_t corners = 0, vertices = 0;
  for (int trial = 0; trial < trials(200); ++trial) {
    CAPTURE(trial);
    Random random(static_cast<std::uint64_t>(trial) + 1);
    auto const corner_list = corner_points(random);
    SceneBuilder builder("outlines");
    builder.begin_object("few");
    builder.add(Box{{0, 0, 0}, {1, 1, 1}});
    builder.begin_object("many");
    for (std::size_t i = 0; i + 2 < corner_list.size(); i += 3) {
      auto const first = builder.add_vertex(corner_list[i]);
      builder.add_vertex(corner_list[i + 1]);
      builder.add_vertex(corner_list[i + 2]);
      builder.add_triangle(first, first + 1, first + 2);
    }
    Scene const scene = builder.finish();
    ConvexBodies const bodies(scene);
    ObjectOutlines const outlines(bodies);
    std::vector<Point3d> points;  // triangles without area have no bodies
    for (auto const& body : bodies.bodies_of(1)) bodies.append_vertices(body, points);
    if (bodies.bodies_of(1).size() <= ObjectOutlines::few_bodies) continue;
    REQUIRE(outlines.of(0).empty());
    auto const outline = outlines.of(1);
    REQUIRE(!outline.empty());
    for (auto const& corner : outline)
      REQUIRE(std::ranges::any_of(points, [&](Point3d const& p) { return horizontal(p) == corner; }));
    std::size_t const n = outline.size();
    for (std::size_t i = 0; i < n && n >= 3; ++i) {
      Point2d const &a = outline[i], &b = outline[(i + 1) % n];
      REQUIRE(is_positive(orient2d<Filtered>(a, b, outline[(i + 2) % n])));
      for (auto const& p : points) REQUIRE(!is_negative(orient2d<Filtered>(a, b, horizontal(p))));
    }
    if (n < 3)
      for (double Point2d::*axis : {&Point2d::x, &Point2d::y}) {
        auto const [low, high] = std::ranges::minmax(outline, {}, axis);
        for (auto const& p : points) REQUIRE((low.*axis <= horizontal(p).*axis && horizontal(p).*axis <= high.*axis));
      }
    corners += n;
    vertices += points.size();
  }
  CAPTURE(corners, vertices);
  CHECK(3 * corners < vertices);  // of discs all are
}
