#include "support/catch.hpp"
#include "support/random_scenes.hpp"

#include "visibility/methods/strong_occlusion/verdict.hpp"

using namespace visibility;
using namespace visibility::test;
using namespace visibility::strong_occlusion;

namespace {

/// A cell on a small grid: a box, or the hull of some points.
ViewCell some_cell(Random& random, bool box)
{
  if (box) return ViewCell(grid_box(random, -3, 3));
  return ViewCell::hull(grid_polyhedron(random, -3, 3).vertices);
}

/// A box, perhaps flat, or a convex polygon or polyhedron.
std::vector<Point3d> some_target(Random& random, bool& is_box)
{
  is_box = random.chance(0.5);
  Point3d const shift{double(random.between(-9, 9)), double(random.between(-9, 9)), double(random.between(-9, 9))};
  std::vector<Point3d> out;
  if (is_box) {
    Box b = grid_box(random, -2, 2);
    if (random.chance(0.3)) b.max.x = b.min.x;
    if (random.chance(0.2)) b.max.z = b.min.z;
    auto const corners = b.corners();
    out.assign(corners.begin(), corners.end());
  } else if (random.chance(0.5)) {
    out = grid_polyhedron(random, -2, 2).vertices;
  } else {
    out = {random.grid_point(-2, 2), random.grid_point(-2, 2), random.grid_point(-2, 2)};
  }
  for (auto& p : out) p = {p.x + shift.x, p.y + shift.y, p.z + shift.z};
  return out;
}

Target target_from(std::vector<Point3d> const& vertices, bool is_box)
{
  Target t = target_of(vertices);
  t.is_box = is_box;
  return t;
}

}  // namespace

TEST_CASE("hull rays: a body blocks the rays along hull edges iff it blocks all", "[methods][law][oracle]")
{
  auto const box_cell = GENERATE(true, false);
  Random random(11);
  int blocked = 0, free = 0;
  for (int i = 0; i < 6000; ++i) {
    CAPTURE(box_cell, i);
    ViewCell const cell = some_cell(random, box_cell);
    bool is_box = false;
    auto const vertices = some_target(random, is_box);
    Target const target = target_from(vertices, is_box);
    if (!certainly_disjoint(cell, target.bounds)) continue;
    Scene const scene = grid_scene(random, 6, -9, 9, Mix::all);
    ConvexBodies const bodies(scene);
    Occluders const occluders(bodies);
    Shaft all(cell, Shaft::Rays::all, Shaft::Culling::all_rays),
      hull(cell, Shaft::Rays::hull_edges, Shaft::Culling::all_rays);
    all.aim(target);
    hull.aim(target);
    all.prepare_culling();
    hull.prepare_culling();
    REQUIRE_FALSE(hull.rays().empty());
    REQUIRE(hull.rays().size() <= all.rays().size());
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b) {
      Counts counts;
      bool const truth = std::ranges::all_of(all.rays(), [&](Ray const& r) {
        return segment_meets<Rational, End::excluded>(bodies, bodies.bodies()[b], exact(r.from), exact(r.to));
      });
      REQUIRE(blocks_all<Filtered>(occluders, std::uint32_t(b), all, counts) == truth);
      REQUIRE(blocks_all<Filtered>(occluders, std::uint32_t(b), hull, counts) == truth);
      // Culling keeps what blocks.
      if (truth) {
        REQUIRE(all.may_block_all(bodies.bounds()[b]));
        REQUIRE(hull.may_block_all(bodies.bounds()[b]));
      }
      blocked += truth;
      free += !truth;
    }
  }
  REQUIRE(blocked > 50);
  REQUIRE(free > 50);
}

TEST_CASE("hull rays: from box to box there are at most eight of the 64", "[methods]")
{
  Random random(12);
  std::size_t most = 0;
  for (int i = 0; i < 5000; ++i) {
    ViewCell const cell(grid_box(random, -3, 3));
    BoxTarget const target(grid_box(random, -9, 9));
    if (!certainly_disjoint(cell, target.box)) continue;
    std::vector<Ray> rays;
    append_hull_rays(cell, target.target(), rays);
    REQUIRE_FALSE(rays.empty());
    most = std::max(most, rays.size());
  }
  REQUIRE(most == 8);  // bar above bar, crosswise
}

TEST_CASE("hull rays: they do not decide for a body that touches the cell or the target", "[methods][degenerate]")
{
  // From a small box to a large one, all hull edges start at the back of the small one; a wide plate through its middle
  // meets them all, and hides nothing from the half before the plate. The other way round, they all end at the back.
  Box const small{{0, 0, 0}, {1, 1, 1}}, large{{10, -5, -5}, {12, 6, 6}};
  auto const check = [](Box const& from, Box const& to, Box const& plate) {
    SceneBuilder builder("test");
    builder.begin_object("plate");
    builder.add(plate);
    Scene const scene = builder.finish();
    ConvexBodies const bodies(scene);
    Occluders const occluders(bodies);
    ViewCell const cell(from);
    BoxTarget const target(to);
    Shaft shaft(cell, Shaft::Rays::hull_edges, Shaft::Culling::all_rays);
    shaft.aim(target.target());
    for (auto const& r : shaft.rays())
      REQUIRE(segment_meets<Rational, End::excluded>(plate, exact(r.from), exact(r.to)));
    Counts counts;
    REQUIRE_FALSE(blocks_all<Filtered>(occluders, 0, shaft, counts));
  };
  Box const plate{{0.5, -9, -9}, {0.75, 9, 9}};
  check(small, large, plate);
  check(large, small, plate);
}
