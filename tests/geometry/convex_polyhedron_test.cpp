#include "support/catch.hpp"
#include "visibility/geometry/convex_polyhedron.hpp"
#include "visibility/geometry/convex_prism.hpp"

#include <map>
#include <stdexcept>

using namespace visibility;

using Facets = std::vector<std::array<ConvexPolyhedron::Index, 3>>;

TEST_CASE("ConvexPolyhedron: a tetrahedron is one, inside out it is none", "[geometry]")
{
  std::vector<Point3d> const v{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK_NOTHROW(ConvexPolyhedron::from_facets(v, Facets{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}).validate());
  CHECK_THROWS_AS(ConvexPolyhedron::from_facets(v, Facets{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}),
                  std::invalid_argument);
  CHECK_THROWS_AS(ConvexPolyhedron::from_facets(v, Facets{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}),
                  std::invalid_argument);  // open
  CHECK_THROWS_AS(ConvexPolyhedron::from_facets(v, Facets{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 4}}),
                  std::invalid_argument);
}

TEST_CASE("ConvexPolyhedron: two one-sided sheets without walls are no polyhedron", "[geometry][regression]")
{
  // Top and bottom of a hexagonal prism, each covered by the six-vertex projective plane: ten triangles, every edge in
  // two of them. Every facet supports the hull and V + F = E + 2, but the walls are missing.
  Facets const sheet{{0, 1, 2}, {0, 1, 3}, {0, 2, 4}, {0, 3, 5}, {0, 4, 5},
                     {1, 2, 5}, {1, 3, 4}, {1, 4, 5}, {2, 3, 4}, {2, 3, 5}};
  std::map<std::pair<unsigned, unsigned>, int> uses;
  for (auto const& f : sheet)
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(f[i], f[(i + 1) % 3])];
  REQUIRE(uses.size() == 15);
  for (auto const& [edge, n] : uses) REQUIRE(n == 2);

  std::vector<Point3d> v;
  for (double const z : {0.0, 1.0})
    for (auto const& [x, y] : {std::pair(2, 0), {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}})
      v.push_back({double(x), double(y), z});
  Facets facets;
  for (auto const& f : sheet) {
    facets.push_back({f[0] + 6, f[1] + 6, f[2] + 6});  // indices rise counterclockwise
    facets.push_back({f[0], f[2], f[1]});
  }
  CHECK_THROWS_AS(ConvexPolyhedron::from_facets(v, facets), std::invalid_argument);
}

TEST_CASE("ConvexPolyhedron: the hull keeps extreme points only, bit for bit", "[geometry]")
{
  std::vector<Point3d> points;
  for (int i = 0; i < 27; ++i) points.push_back({0.1 * (i % 3), 0.1 * (i / 3 % 3), 0.1 * (i / 9)});
  auto const cube = ConvexPolyhedron::hull(points);
  cube.validate();
  CHECK(cube.vertices.size() == 8);
  for (auto const& v : cube.vertices) CHECK(std::ranges::find(points, v) != points.end());
  points.resize(9);
  CHECK_THROWS_AS(ConvexPolyhedron::hull(points), std::invalid_argument);  // flat
  CHECK_THROWS_AS(ConvexPolyhedron::hull(std::vector<Point3d>{}), std::invalid_argument);
}

TEST_CASE("ConvexPrism: broken footprints are named", "[geometry]")
{
  CHECK_NOTHROW(ConvexPrism{{{0, 0}, {1, 0}, {2, 0}, {1, 1}}, 0, 1}.validate());
  CHECK_THROWS_AS((ConvexPrism{{{0, 0}, {1, 1}, {1, 0}}, 0, 1}.validate()), std::logic_error);          // clockwise
  CHECK_THROWS_AS((ConvexPrism{{{0, 0}, {1, 0}, {1, 0}, {0, 1}}, 0, 1}.validate()), std::logic_error);  // repeated
  CHECK_THROWS_AS((ConvexPrism{{{0, 0}, {1, 0}, {2, 0}}, 0, 1}.validate()), std::logic_error);          // no area
  CHECK_THROWS_AS((ConvexPrism{{{0, 0}, {1, 0}, {0, 1}}, 1, 1}.validate()), std::logic_error);          // no height
  CHECK_THROWS_AS((ConvexPrism{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0.5}, {4, 0.5}, {4, 4}, {0, 4}}, 0, 1}.validate()),
                  std::logic_error);
  // A star that turns left at every corner but goes round twice.
  CHECK_THROWS_AS((ConvexPrism{{{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}}, 0, 1}.validate()), std::logic_error);
}
