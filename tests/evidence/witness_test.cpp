#include "scenes.hpp"
#include "support/catch.hpp"
#include "visibility/evidence/witness.hpp"
#include "visibility/scene/meets_cell.hpp"

using namespace visibility;
using test::boxes;

namespace {

ViewCell const unit_cell(Box{{0, 0, 0}, {1, 1, 1}});

Witness line(std::uint32_t object, Point3d const& from, Point3d const& to) { return {object, exact(from), exact(to)}; }

Box wall_x(double x, double y0, double y1) { return {{x, y0, -10}, {x + 1, y1, 10}}; }

}  // namespace

TEST_CASE("witness: a free line from the cell's interior into a face is confirmed", "[evidence][law]")
{
  auto const s = boxes({wall_x(5, -1, 2)});
  CHECK(confirm(*s.prepared, unit_cell, line(0, {0.5, 0.5, 0.5}, {5, 0.25, 0.5})));
}

TEST_CASE("witness: both ends must be in open sets", "[evidence][degenerate]")
{
  auto const s = boxes({wall_x(5, -1, 2)});
  auto const& p = *s.prepared;
  CHECK_FALSE(confirm(p, unit_cell, line(0, {1, 0.5, 0.5}, {5, 0.5, 0.5})));      // on the cell's boundary
  CHECK_FALSE(confirm(p, unit_cell, line(0, {0.5, 0.5, 0.5}, {5, -1, 0.5})));     // on an edge of the box
  CHECK_FALSE(confirm(p, unit_cell, line(0, {0.5, 0.5, 0.5}, {4.5, 0.5, 0.5})));  // on no face
  CHECK_FALSE(confirm(p, unit_cell, line(0, {0.5, 0.5, 0.5}, {5.5, 0.5, 0.5})));  // inside the box
  CHECK_FALSE(
    confirm(p, unit_cell, line(0, {0.5, 0.5, 0.5}, {6, 0.5, 0.5})));  // the far face: hidden by the box itself
  CHECK_FALSE(confirm(p, unit_cell, line(7, {0.5, 0.5, 0.5}, {5, 0.5, 0.5})));    // no such object
  CHECK_FALSE(confirm(p, unit_cell, line(0, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5})));  // no line
}

TEST_CASE("witness: a line that grazes an edge is blocked", "[evidence][degenerate]")
{
  auto const s = boxes({wall_x(10, -9, 9), Box{{5, 0.5, -10}, {6, 3, 10}}});
  CHECK_FALSE(confirm(*s.prepared, unit_cell, line(0, {0.5, 0.5, 0.5}, {10, 0.5, 0.5})));  // along the side's plane
  CHECK(confirm(*s.prepared, unit_cell, line(0, {0.5, 0.4999, 0.5}, {10, 0.4999, 0.5})));
}

TEST_CASE("witness: nothing is seen through the slit between abutting boxes", "[evidence][degenerate]")
{
  auto const s = boxes({wall_x(10, -9, 9), wall_x(5, -99, 0.5), wall_x(5, 0.5, 99)});
  CHECK_FALSE(confirm(*s.prepared, unit_cell, line(0, {0.5, 0.5, 0.5}, {10, 0.5, 0.5})));
}

TEST_CASE("witness: two coinciding faces are both visible", "[evidence][degenerate]")
{
  auto const s = boxes({wall_x(5, -1, 2), wall_x(5, -1, 2)});
  for (std::uint32_t i : {0U, 1U}) CHECK(confirm(*s.prepared, unit_cell, line(i, {0.5, 0.5, 0.5}, {5, 0.5, 0.5})));
}

TEST_CASE("witness: the points of a sphere are rational and seen from their own side only", "[evidence][law]")
{
  SceneBuilder b("ball");
  b.begin_object("ball");
  b.add(Ball{{5, 0.5, 0.5}, 2});
  test::TestScene const s(b.finish());
  CHECK(confirm(*s.prepared, unit_cell, line(0, {0.5, 0.5, 0.5}, {3, 0.5, 0.5})));
  CHECK_FALSE(confirm(*s.prepared, unit_cell, line(0, {0.5, 0.5, 0.5}, {7, 0.5, 0.5})));
  CHECK_FALSE(confirm(*s.prepared, unit_cell, line(0, {0.5, 0.5, 0.5}, {3, 0.5, 0.75})));
  for (Point3d const& near : {Point3d{3.1, 0.9, 0.2}, Point3d{3.5, 1.5, 1.25}, Point3d{4, -0.5, 1}}) {
    auto const w = find_witness(*s.prepared, {0, {Face::Kind::sphere, 0, 0}, {0.5, 0.5, 0.5}, near});
    REQUIRE(w);
    CHECK(confirm(*s.prepared, unit_cell, *w));
  }
}

TEST_CASE("witness: a ball that peeks past a box is seen, a box that covers it hides it", "[evidence]")
{
  for (bool const covered : {false, true}) {
    SceneBuilder b("ball");
    b.begin_object("wall");
    b.add(wall_x(3, -50, covered ? 50 : 1.5));
    b.begin_object("ball");
    b.add(Ball{{8, 0.5, 0.5}, 2.5});
    test::TestScene const s(b.finish());
    bool seen = false;
    for (double y = -1; y < 4; y += 0.25)
      for (double f : {0.01, 0.5, 0.99}) {
        auto const w = find_witness(*s.prepared, {1, {Face::Kind::sphere, 0, 0}, {0.5, f, 0.5}, {6.5, y, 0.5}});
        CHECK((!w || confirm(*s.prepared, unit_cell, *w)));
        seen |= w.has_value();
      }
    CHECK(seen == !covered);
  }
}

TEST_CASE("witness: a triangle seen edge-on or without area has nothing to see", "[evidence][degenerate]")
{
  SceneBuilder b("triangles");
  auto const add = [&](char const* name, Point3d const& p, Point3d const& q, Point3d const& r) {
    b.begin_object(name);
    b.add_triangle(b.add_vertex(p), b.add_vertex(q), b.add_vertex(r));
  };
  add("front", {5, 0, 0}, {5, 1, 0}, {5, 0, 1});
  add("edge-on", {5, 3, 0.5}, {7, 3, 0.5}, {5, 5, 0.5});
  add("needle", {5, 8, 0}, {5, 9, 0}, {5, 10, 0});
  test::TestScene const s(b.finish());
  auto const& p = *s.prepared;
  Point3d const from{0.5, 0.5, 0.5};
  CHECK(find_witness(p, {0, {Face::Kind::triangle, 0, 0}, from, {5, 0.2, 0.2}}));
  CHECK_FALSE(find_witness(p, {1, {Face::Kind::triangle, 1, 0}, from, {5.5, 3.5, 0.5}}));
  CHECK(find_witness(p, {1, {Face::Kind::triangle, 1, 0}, {0.5, 0.5, 0.75}, {5.5, 3.5, 0.5}}));
  CHECK_FALSE(find_witness(p, {2, {Face::Kind::triangle, 2, 0}, from, {5, 9, 0}}));
}

TEST_CASE("witness: slanted walls, roofs and facets get exact rational ends", "[evidence][law]")
{
  SceneBuilder b("solids");
  b.begin_object("prism");
  b.add(Prism{{{{4, -3}, {9, -2}, {8.3, 4.1}, {5.1, 0.7}, {4.7, 3.3}}, {{6, -1}, {7, -1}, {6.5, 0}}}, -1, 0.3});
  b.begin_object("tetrahedron");
  b.add(ConvexPolyhedron::hull(std::vector<Point3d>{{-5, 0.1, 0}, {-7, 3.3, 0.2}, {-7, -3, 0.1}, {-6, 0, 5.7}}));
  test::TestScene const s(b.finish());
  test::Random random(5);
  int proved = 0, slanted = 0;
  for (int i = 0; i < 400; ++i) {
    Point3d const from = random.point(0.01, 0.99),
                  near{random.uniform(4, 9), random.uniform(-3, 4), random.uniform(-1, 0.3)};
    Candidate c{0, {}, from, near};
    switch (random.below(3)) {
    case 0: c.face = {Face::Kind::wall, 0, static_cast<std::uint32_t>(random.below(8))}; break;
    case 1: {
      auto const body =
        static_cast<std::uint32_t>(random.below(static_cast<int>(s.prepared->bodies().bodies_of(0).size())));
      c.face = {Face::Kind::roof, body, 0};
      c.near.z = 0.3;
      break;
    }
    default:
      c.object = 1;
      c.face = {Face::Kind::facet, 0, static_cast<std::uint32_t>(random.below(4))};
      c.near = {random.uniform(-7, -5), random.uniform(-3, 3), random.uniform(0, 5)};
    }
    auto const w = find_witness(*s.prepared, c);
    if (!w) continue;
    CAPTURE(i, int(c.face.kind), c.face.part);
    REQUIRE(confirm(*s.prepared, unit_cell, *w));
    ++proved;
    slanted += exact(Point3d{CGAL::to_double(w->to.x), CGAL::to_double(w->to.y), CGAL::to_double(w->to.z)}) != w->to;
  }
  CHECK(proved > 50);
  CHECK(slanted > 10);
}

TEST_CASE("meets_cell: touching counts, for every kind of body", "[evidence][degenerate]")
{
  SceneBuilder b("touch");
  auto const triangle = [&](Point3d const& p, Point3d const& q, Point3d const& r) {
    b.add_triangle(b.add_vertex(p), b.add_vertex(q), b.add_vertex(r));
  };
  std::vector<bool> expected;
  auto const begin = [&](bool meets) { b.begin_object("o"), expected.push_back(meets); };
  begin(true), b.add(Box{{1, 1, 1}, {2, 2, 2}});
  begin(false), b.add(Box{{1, 1, std::nextafter(1, 2)}, {2, 2, 2}});
  begin(true), b.add(Box{{-5, -5, -5}, {5, 5, 5}});
  begin(true), b.add(Box{{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}});
  begin(true), b.add(Ball{{3, 0.5, 0.5}, 2});
  begin(false), b.add(Ball{{3, 0.5, 0.5}, std::nextafter(2, 0)});
  begin(true), b.add(Ball{{4, 5, 0.5}, 5});  // touches an edge: 3-4-5
  begin(false), b.add(Ball{{4, 5, 0.5}, std::nextafter(5, 0)});
  begin(true), b.add(Ball{{0.5, 0.5, 0.5}, 0});
  begin(true), b.add(Prism{{{{1, 0.5}, {3, -1}, {3, 2}}}, 1, 4});
  begin(false), b.add(Prism{{{{1, 0.5}, {3, -1}, {3, 2}}}, 1.5, 4});
  begin(false), b.add(Prism{{{{1.75, 0.5}, {0.5, 1.75}, {1.75, 1.75}}}, 0, 4});
  begin(true), triangle({-5, -5, 0.5}, {9, -5, 0.5}, {0, 9, 0.5});  // cuts the cell without an edge inside
  begin(false), triangle({3, 0, 0}, {0, 3, 0}, {0, 0, 3.5});
  begin(true), triangle({3, 0, 0}, {0, 3, 0}, {0, 0, 3});   // through the corner (1, 1, 1)
  begin(true), triangle({-1, 0, 0}, {2, 0, 0}, {3, 0, 0});  // degenerate, along an edge of the cell
  test::TestScene const s(b.finish());
  ViewCell const hull = ViewCell::hull(unit_cell.vertices());
  for (std::uint32_t i = 0; i < expected.size(); ++i) {
    CAPTURE(i);
    CHECK(meets_cell(*s.prepared, unit_cell, i) == expected[i]);
    CHECK(meets_cell(*s.prepared, hull, i) == expected[i]);
  }
}
