#include "support/catch.hpp"
#include "support/random.hpp"

#include "polygon_triangulation.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient2d.hpp"

using namespace visibility;
using namespace visibility::readers;

namespace {

using Ring = std::vector<VertexIndex>;

/// Whether p, which shares no coordinate with any vertex, is inside the ring: crossings of the ray to the right.
bool inside(std::vector<Point3d> const& at, Ring const& ring, Point2d const& p)
{
  bool in = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Point2d a = horizontal(at[ring[i]]), b = horizontal(at[ring[(i + 1) % ring.size()]]);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.y > b.y) std::swap(a, b);
    in ^= is_positive(orient2d<Filtered>(a, b, p));
  }
  return in;
}

}  // namespace

TEST_CASE("triangulation: covers the polygon and nothing else", "[readers][law]")
{
  test::Random random(3);
  int done = 0, refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    // Rings on a small grid touch, cross and overlap often.
    std::vector<Point3d> at;
    std::vector<Ring> rings;
    for (int r = 0, n = random.between(1, 3); r < n; ++r) {
      auto& ring = rings.emplace_back();
      for (int i = 0, k = random.between(3, r == 0 ? 8 : 4); i < k; ++i) {
        int const lo = r == 0 ? 0 : 2, hi = r == 0 ? 8 : 6;
        ring.push_back(static_cast<VertexIndex>(at.size()));
        double const x = random.between(lo, hi), y = random.between(lo, hi);
        at.push_back({x, y, 2 * x - y});
      }
      drop_repeats(at, ring);
    }
    if (rings[0].size() < 3) continue;
    std::erase_if(rings, [](Ring const& r) { return r.size() < 3; });
    std::vector<IndexTriangle> triangles;
    CAPTURE(trial);
    if (triangulate(at, rings, triangles) != Triangulated::yes) {
      ++refused;
      REQUIRE(triangles.empty());
      continue;
    }
    ++done;
    for (double x = 0.37; x < 8; x += 0.531)
      for (double y = 0.23; y < 8; y += 0.617) {
        bool expected = inside(at, rings[0], {x, y});
        for (std::size_t r = 1; r < rings.size(); ++r) expected = expected && !inside(at, rings[r], {x, y});
        int covers = 0;
        for (auto const& t : triangles) covers += inside(at, {t[0], t[1], t[2]}, {x, y});
        CAPTURE(x, y);
        REQUIRE(covers == (expected ? 1 : 0));
      }
  }
  REQUIRE(done > 300);
  REQUIRE(refused > 300);
}

TEST_CASE("triangulation: seen along the axis of the normal, in any position", "[readers]")
{
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Point3d> at;
    for (auto const& [u, v] : std::vector<std::pair<double, double>>{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}})
      at.push_back(axis == 0 ? Point3d{7, u, v} : axis == 1 ? Point3d{v, 7, u} : Point3d{u, v, 7});
    std::vector<IndexTriangle> triangles;
    std::vector<Ring> const rings{{0, 1, 2, 3, 4}};
    REQUIRE(triangulate(at, rings, triangles) == Triangulated::yes);
    CHECK(triangles.size() == 3);
  }
}

TEST_CASE("triangulation: keyholes and rings that touch at a point", "[readers][degenerate]")
{
  // A hole joined to the outer ring by an edge run twice.
  std::vector<Point3d> const at{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}};
  std::vector<IndexTriangle> triangles;
  std::vector<Ring> const keyhole{{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}};
  REQUIRE(triangulate(at, keyhole, triangles) == Triangulated::yes);
  CHECK(triangles.size() == 8);
  // A hole that shares an edge with the outer ring.
  std::vector<Point3d> const notch{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {3, 0, 0}, {6, 0, 0}, {4, 5, 0}};
  triangles.clear();
  std::vector<Ring> const shared{{0, 1, 2, 3}, {4, 5, 6}};
  REQUIRE(triangulate(notch, shared, triangles) == Triangulated::yes);
  CHECK(triangles.size() == 5);
  // A hole outside, and one over another.
  std::vector<Ring> const outside{{0, 1, 2}, {3, 5, 6}};
  CHECK(triangulate(at, outside, triangles) == Triangulated::not_simple);
  std::vector<Ring> const twice{{0, 1, 2, 3}, {4, 5, 6}, {4, 5, 6}};
  CHECK(triangulate(at, twice, triangles) == Triangulated::not_simple);
  std::vector<Ring> const line{{0, 1, 0, 1}};
  CHECK(triangulate(at, line, triangles) == Triangulated::no_area);
}
