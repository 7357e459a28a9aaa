#include "scene/inner_certificate.hpp"

#include "meshes.hpp"
#include "support/catch.hpp"

#include <limits>
#include <numeric>

using namespace visibility;
using namespace visibility::test;

namespace {

detail::MeshShell shell_of(Triangles const& mesh)
{
  Scene const scene = scene_of(mesh);
  std::vector<std::uint32_t> all(scene.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  auto shells = detail::mesh_shells(scene, all, 1000);
  REQUIRE(shells.size() == 1);
  return shells.front();
}

bool certified(detail::MeshShell const& shell, Box const& b)
{
  ConvexPrism const prism{
    {{b.min.x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, b.max.y}, {b.min.x, b.max.y}}, b.min.z, b.max.z};
  bool const result = detail::is_certified(shell, prism);
  CHECK(detail::is_certified(shell, ConvexPolyhedron::from_box(b)) == result);
  return result;
}

}  // namespace

TEST_CASE("inner certificate: holds up to the walls and no further", "[scene][degenerate]")
{
  // A U: bar y < 7, arms x < 6 and x > 18, court 6 < x < 18, y > 7.
  auto const shell = shell_of(extrusion(plan_of(2), 0, 10));
  double const above = std::nextafter(10.0, 11), beyond = std::nextafter(7.0, 8);
  CHECK(certified(shell, {{0, 0, 0}, {24, 7, 10}}));
  CHECK(certified(shell, {{0, 0, 0}, {6, 18, 10}}));
  CHECK(certified(shell, {{1, 1, 1}, {2, 2, 2}}));
  CHECK_FALSE(certified(shell, {{0, 0, 0}, {24, 7, above}}));
  CHECK_FALSE(certified(shell, {{0, 0, 0}, {24, beyond, 10}}));
  CHECK_FALSE(certified(shell, {{0, 0, -1e-300}, {24, 7, 10}}));
  CHECK_FALSE(certified(shell, {{6, 7, 0}, {18, 18, 10}}));     // the court: met by no facet, and outside
  CHECK_FALSE(certified(shell, {{30, 0, 0}, {40, 7, 10}}));     // beside
  CHECK_FALSE(certified(shell, {{0, 0, 10}, {24, 7, 20}}));     // on top
  CHECK_FALSE(certified(shell, {{0, 0, -20}, {24, 7, 0}}));     // below
  CHECK_FALSE(certified(shell, {{-9, -9, -9}, {30, 30, 30}}));  // around everything
}

TEST_CASE("inner certificate: stays above the floor of an open mesh", "[scene]")
{
  auto mesh = extrusion(plan_of(2), 0, 10);
  std::erase_if(mesh, [](Triangle const& t) { return bounding_box(t).max.z == 0; });
  auto const shell = shell_of(mesh);
  CHECK(shell.floor == 0);
  CHECK(certified(shell, {{0, 0, 0}, {24, 7, 10}}));
  CHECK_FALSE(certified(shell, {{0, 0, -1e-300}, {24, 7, 10}}));
}

TEST_CASE("inner certificate: a tampered shell fails", "[scene]")
{
  auto shell = shell_of(extrusion(plan_of(2), 0, 10));
  Box const bar{{0, 0, 0}, {24, 7, 10}};
  REQUIRE(certified(shell, bar));
  auto pierced = shell;
  pierced.vertices.insert(pierced.vertices.end(), {{12, 3, -5}, {12, 3, 15}, {50, 3, 5}});
  auto const n = static_cast<std::uint32_t>(pierced.vertices.size());
  pierced.facets.push_back({n - 3, n - 2, n - 1});
  CHECK_FALSE(certified(pierced, bar));
  // A lid far above changes the parity below it.
  auto covered = shell;
  covered.vertices.insert(covered.vertices.end(), {{-100, -100, 50}, {200, -100, 50}, {0, 300, 50}});
  covered.facets.push_back({n - 3, n - 2, n - 1});
  CHECK_FALSE(certified(covered, bar));
}

TEST_CASE("inner certificate: enclosed is decided for points under edges and vertices", "[scene][degenerate]")
{
  Random random(91);
  auto mesh = extrusion(plan_of(0), 0, 10);
  shuffle(mesh, random);
  auto const shell = shell_of(mesh);
  // Grid points lie under the edges, diagonals and vertices of the roof's triangles.
  for (int x = -1; x <= 21; ++x)
    for (int y = -1; y <= 21; ++y) {
      bool const inside = x > 0 && y > 0 && ((x < 20 && y < 8) || (x < 8 && y < 20));
      bool const on_wall = ((y == 0 || y == 8) && x >= 0 && x <= 20) || ((x == 0 || x == 8) && y >= 0 && y <= 20) ||
                           (x == 20 && y >= 0 && y <= 8) || (y == 20 && x >= 0 && x <= 8);
      CAPTURE(x, y);
      if (inside || !on_wall) CHECK(detail::encloses(shell, {double(x), double(y), 5}) == inside);
      CHECK_FALSE(detail::encloses(shell, {double(x), double(y), 11}));
      CHECK_FALSE(detail::encloses(shell, {double(x), double(y), -1}));
    }
}

TEST_CASE("inner certificate: shells are told apart and joined by their edges", "[scene]")
{
  auto const shells = [](Triangles const& mesh) {
    Scene const scene = scene_of(mesh);
    std::vector<std::uint32_t> all(scene.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return detail::mesh_shells(scene, all, 1000);
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Ring const left{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, right{{4, 4}, {8, 4}, {8, 8}, {4, 8}};
  Triangles two = extrusion(left, 0, 5);
  append(two, extrusion(right, 0, 5));  // touch along an edge, which four facets use
  CHECK(shells(two).size() == 2);
  two.erase(two.begin() + 1);  // break the one: the other stays closed
  REQUIRE(shells(two).size() == 1);
  CHECK(shells(two)[0].floor == -infinity);
  CHECK(shells(two)[0].bounds == Box{{4, 4, 0}, {8, 8, 5}});
  // Four open-ended walls that fit, each a component of its own because its neighbours are split elsewhere.
  Triangles sleeve;
  double const z[4][2] = {{2, 3}, {1, 4}, {2, 4}, {1, 3}};
  for (std::size_t i = 0; i < 4; ++i) {
    Point2d const a = left[i], b = left[(i + 1) % 4];
    double low = 0;
    for (double const high : {z[i][0], z[i][1], 5.0}) {
      add_quad(sleeve, lifted(a, low), lifted(b, low), lifted(b, high), lifted(a, high));
      low = high;
    }
  }
  add_quad(sleeve, {0, 0, 5}, {4, 0, 5}, {4, 4, 5}, {0, 4, 5});
  auto const joined = shells(sleeve);
  REQUIRE(joined.size() == 1);
  CHECK(joined[0].floor == 0);
}
