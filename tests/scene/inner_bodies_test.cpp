#include "visibility/scene/inner_bodies.hpp"

#include "inner_body_checks.hpp"
#include "support/trials.hpp"

#include "visibility/scene/generators.hpp"

#include <limits>
#include <numeric>

using namespace visibility;
using namespace visibility::test;

namespace {

std::vector<InnerBody> bodies_of(Triangles const& mesh, InnerBodyOptions const& options = {})
{
  Scene const scene = scene_of(mesh);
  std::vector<std::uint32_t> all(scene.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return inner_bodies(scene, scene.objects[0], all, options);
}

double volume(InnerBody const& k)
{
  auto const body = ConvexPolyhedron::hull(corners(k));
  double sum = 0;
  Point3d const& o = body.vertices[0];
  for (auto const& f : body.facets) {
    Point3d v[3];
    for (std::size_t i = 0; i < 3; ++i) {
      Point3d const& p = body.vertices[f.vertices[i]];
      v[i] = {p.x - o.x, p.y - o.y, p.z - o.z};
    }
    sum += v[0].x * (v[1].y * v[2].z - v[1].z * v[2].y) + v[0].y * (v[1].z * v[2].x - v[1].x * v[2].z) +
           v[0].z * (v[1].x * v[2].y - v[1].y * v[2].x);
  }
  return sum / 6;
}

double largest_volume(std::vector<InnerBody> const& bodies)
{
  double v = 0;
  for (auto const& k : bodies) v = std::max(v, volume(k));
  return v;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("inner bodies: what an inner body blocks, the mesh blocks", "[scene][law][conservative]")
{
  Random random(81);
  Reached reached;
  for (int i = 0; i < trials(48); ++i) {
    CAPTURE(i);
    Ring ring = plan_of(random.below(plan_kinds));
    if (random.chance(0.6))
      ring = turned(ring, random.uniform(0, 6), random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3));
    Triangles mesh;
    switch (i % 8) {
    case 0: mesh = extrusion(ring, random.uniform(-2, 2), random.uniform(5, 30)); break;
    case 1: mesh = gabled_house(random, 0); break;
    case 2: mesh = gabled_house(random, 0.01); break;
    case 3: mesh = dented_box(random, random.between(1, 4)); break;
    case 4: mesh = twisted(plan_of(random.below(plan_kinds)), random.uniform(0.1, 1.5)); break;
    case 5:  // interpenetrating; the smaller one also hangs in the air
      mesh = extrusion(ring, 0, 10);
      append(mesh, extrusion(ring, random.between(2, 12), 20));
      break;
    case 6: {  // open at the bottom
      mesh = extrusion(ring, 1, 12);
      std::erase_if(mesh, [](Triangle const& t) { return bounding_box(t).max.z == 1; });
      break;
    }
    case 7: {  // two storeys of different plan whose edges do not fit
      mesh = extrusion(plan_of(0), 0, 8);
      append(mesh, extrusion({{2, 0}, {8, 0}, {8, 20}, {2, 20}}, 8, 20));
      break;
    }
    }
    shuffle(mesh, random);
    check_promise(mesh, bodies_of(mesh), random, 40, reached);
  }
  CAPTURE(reached.meshes, reached.bodies, reached.hulls, reached.lines, reached.blocked);
  REQUIRE(reached.bodies > 2 * reached.meshes);
  REQUIRE(reached.hulls > reached.meshes / 4);
  REQUIRE(reached.blocked > reached.lines / 4);
  REQUIRE(reached.lines - reached.blocked > reached.lines / 10);
}

TEST_CASE("inner bodies: an L gives its two bars, exactly", "[scene]")
{
  auto const bodies = bodies_of(extrusion(plan_of(0), 0, 10));
  REQUIRE(bodies.size() >= 2);
  auto const has = [&](Box const& bar) {
    return std::ranges::any_of(bodies, [&](InnerBody const& k) {
      auto const* prism = std::get_if<ConvexPrism>(&k.shape);
      return prism != nullptr && prism->footprint.size() == 4 && bounding_box(*prism) == bar;
    });
  };
  CHECK(has({{0, 0, 0}, {20, 8, 10}}));
  CHECK(has({{0, 0, 0}, {8, 20, 10}}));
  for (auto const& k : bodies) CHECK(k.floor == -infinity);
}

TEST_CASE("inner bodies: a house with a roof is one body, up to its noise", "[scene]")
{
  for (int seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    double const noise = seed % 2 == 0 ? 0 : 0.005;
    Random random(static_cast<std::uint64_t>(seed));
    auto const house = gabled_house(random, noise);
    std::vector<Point3d> points;
    for (auto const& t : house) points.insert(points.end(), t.vertices.begin(), t.vertices.end());
    double const whole = volume({ConvexPolyhedron::hull(points), 0, true});
    auto const bodies = bodies_of(house);
    CHECK(largest_volume(bodies) > (noise == 0 ? 0.999 : 0.95) * whole);
  }
}

TEST_CASE("inner bodies: what stands on a level foot reaches it, exactly, and stands on it with all its points",
          "[scene][law]")
{
  Random random(82);
  int roofs = 0;
  for (int i = 0; i < trials(12); ++i) {
    CAPTURE(i);
    auto const specification = "district,n=1,seed=" + std::to_string(i) + ",rotation=" + std::to_string(i % 3 * 17);
    Scene const scene = generate(specification);
    Triangles mesh;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) mesh.push_back(scene.triangle(t));
    auto const bodies = bodies_of(mesh);
    REQUIRE(!bodies.empty());
    auto const all = corners(bodies[0]);  // the largest
    double foot = infinity;
    for (auto const& p : all) foot = std::min(foot, p.z);
    REQUIRE(foot == bounds_of(mesh).min.z);
    std::vector<Point3d> grounded = all;
    for (auto const& p : all) grounded.push_back({p.x, p.y, foot});
    // Feet add nothing to the hull.
    auto const hull = ConvexPolyhedron::hull(grounded);
    REQUIRE(hull.vertices.size() == all.size());
    roofs += std::holds_alternative<ConvexPolyhedron>(bodies[0].shape);
  }
  REQUIRE(roofs > 0);
}

TEST_CASE("inner bodies: without a wall triangle there are none", "[scene][degenerate]")
{
  Random random(82);
  for (int kind = 0; kind < plan_kinds; ++kind) {
    Ring const ring = turned(plan_of(kind), 0.3 * kind, 0, 0);
    auto const whole = extrusion(ring, 0, 10);
    REQUIRE_FALSE(bodies_of(whole).empty());
    for (int i = 0; i < 6; ++i) {
      Triangles broken = whole;
      // Walls come in pairs, the second one with the upper edge; the first one still has a vertex at the top.
      broken.erase(broken.begin() + random.below(static_cast<int>(2 * ring.size())));
      shuffle(broken, random);
      CHECK(bodies_of(broken).empty());
    }
  }
}

TEST_CASE("inner bodies: a crack of one unit in the last place is a crack", "[scene][degenerate]")
{
  auto mesh = extrusion(plan_of(1), 0, 10);
  auto& corner = mesh[1].vertices[2];
  REQUIRE(corner.z == 10);
  corner.x = std::nextafter(corner.x, 1e9);
  CHECK(bodies_of(mesh).empty());
}

TEST_CASE("inner bodies: an open bottom sets the floor", "[scene]")
{
  auto mesh = extrusion(plan_of(2), 3, 10);
  std::erase_if(mesh, [](Triangle const& t) { return bounding_box(t).max.z == 3; });
  auto const bodies = bodies_of(mesh);
  REQUIRE_FALSE(bodies.empty());
  for (auto const& k : bodies) {
    CHECK(k.floor == 3);
    CHECK(bounding_box(k).min.z >= 3);
  }
  // A sight line from below the floor may enter through the opening: the floor is not decoration.
  CHECK(blocks(bodies[0], {12, 3, -5}, {12, 3, 5}));
  CHECK_FALSE(blocks(mesh, {12, 3, -5}, {12, 3, 5}));
}

TEST_CASE("inner bodies: for which cells they may be used", "[scene]")
{
  Box const object{{0, 0, 0}, {9, 9, 9}};
  auto const may = [&](double floor, bool needs_outside, Box const& cell) {
    InnerBody body;  // not a temporary: GCC 12 takes its variant for uninitialised under the sanitizers
    body.floor = floor;
    body.needs_outside = needs_outside;
    return may_occlude(body, cell, object);
  };
  CHECK(may(-infinity, false, {{1, 1, -1}, {2, 2, 2}}));
  CHECK_FALSE(may(-infinity, true, {{1, 1, -1}, {2, 2, 2}}));
  CHECK(may(0, true, {{10, 1, 0}, {12, 2, 2}}));
  CHECK_FALSE(may(0, true, {{9, 1, 0}, {12, 2, 2}}));  // touches the box
  CHECK_FALSE(may(0, true, {{10, 1, -1}, {12, 2, 2}}));
}

TEST_CASE("inner bodies: above a damaged storey the next one still counts", "[scene]")
{
  auto mesh = extrusion(plan_of(0), 0, 8);
  std::erase_if(mesh, [](Triangle const& t) { return bounding_box(t).min.z == 8; });  // no roof
  mesh.erase(mesh.begin());                                                           // and a hole in the wall
  auto storey = extrusion(plan_of(0), 8, 20);
  std::erase_if(storey, [](Triangle const& t) { return bounding_box(t).max.z == 8; });
  append(mesh, storey);
  auto const bodies = bodies_of(mesh);
  REQUIRE_FALSE(bodies.empty());
  for (auto const& k : bodies) CHECK(k.floor == 8);
}

TEST_CASE("inner bodies: edges that fit only after cutting are closed", "[scene][degenerate]")
{
  // One wall of a notched box is split at half its height, its neighbours are not: a T-junction on two vertical edges.
  auto mesh = extrusion(plan_of(0), 0, 10);
  mesh.erase(mesh.begin(), mesh.begin() + 2);
  for (double const z : {0.0, 5.0}) add_quad(mesh, {0, 0, z}, {20, 0, z}, {20, 0, z + 5}, {0, 0, z + 5});
  auto const bodies = bodies_of(mesh);
  REQUIRE_FALSE(bodies.empty());
  for (auto const& k : bodies) CHECK(k.floor == -infinity);
  Random random(83);
  Reached reached;
  check_promise(mesh, bodies, random, 100, reached);
  // Off the edge by one unit it is open.
  auto open = mesh;
  for (auto& t : open)
    for (auto& p : t.vertices)
      if (p.z == 5 && p.x == 20) p.x = std::nextafter(20, 30);
  CHECK(bodies_of(open).empty());
}

TEST_CASE("inner bodies: storeys that are solids of their own become one tower", "[scene]")
{
  // Slabs wider than the storeys between them: their common faces are different triangles.
  Ring const storey = turned({{0, 0}, {10, 0}, {10, 6}, {0, 6}}, 0.4, 3, 5);
  Ring const slab = turned({{-1, -1}, {11, -1}, {11, 7}, {-1, 7}}, 0.4, 3, 5);
  auto const tower = [&](double gap) {
    Triangles mesh;
    double z = 0;
    for (int i = 0; i < 5; ++i) {
      append(mesh, extrusion(slab, z, z + 0.5));
      append(mesh, extrusion(storey, z + 0.5, z + 3.5));
      z += 3.5 + (i == 2 ? gap : 0);
    }
    return mesh;
  };
  auto const highest = [](std::vector<InnerBody> const& bodies) {
    double h = 0;
    for (auto const& k : bodies) h = std::max(h, bounding_box(k).max.z - bounding_box(k).min.z);
    return h;
  };
  CHECK(highest(bodies_of(tower(0))) == 17.5);
  CHECK(highest(bodies_of(tower(0x1p-40))) == 10.5);  // a slit is a slit
  Random random(85);
  Reached reached;
  for (double const gap : {0.0, 0x1p-40, 0.5}) {
    auto const mesh = tower(gap);
    check_promise(mesh, bodies_of(mesh), random, 40, reached);
  }
  CHECK(reached.blocked > 100);
}

TEST_CASE("inner bodies: triangles count modulo 2", "[scene][degenerate]")
{
  auto const once = extrusion(plan_of(3), 0, 10);
  auto twice = once;
  append(twice, once);
  auto thrice = twice;
  append(thrice, once);
  CHECK(bodies_of(twice).empty());
  CHECK(bodies_of(thrice).size() == bodies_of(once).size());
}

TEST_CASE("inner bodies: options bound the cost", "[scene]")
{
  auto const mesh = extrusion(plan_of(4), 0, 10);
  REQUIRE(bodies_of(mesh).size() > 1);
  CHECK(bodies_of(mesh, {.max_bodies = 1}).size() == 1);
  CHECK(bodies_of(mesh, {.max_bodies = 0}).empty());
  CHECK(bodies_of(mesh, {.max_triangles = mesh.size() - 1}).empty());
  CHECK(bodies_of(mesh, {.slices = 0}).empty());
  Scene const scene = scene_of(mesh);
  CHECK(inner_bodies(scene, scene.objects[0], {}).empty());  // no loose triangles
}
