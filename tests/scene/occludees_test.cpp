#include "support/catch.hpp"

#include "visibility/scene/exposed_lines.hpp"
#include "visibility/scene/scene_builder.hpp"

using namespace visibility;

namespace {

/// Occludees of a scene that is filled by `add`.
struct Pieces {
  template <class Add>
  explicit Pieces(Add const& add) : scene(built(add)), prepared(scene), occludees(prepared)
  {
  }
  template <class Add>
  static Scene built(Add const& add)
  {
    SceneBuilder builder("test");
    builder.begin_object("object");
    add(builder);
    return builder.finish();
  }
  std::size_t walls() const
  {
    return static_cast<std::size_t>(std::ranges::count_if(occludees.pieces(), &Occludees::Piece::is_wall));
  }
  std::size_t tops() const { return occludees.pieces().size() - walls(); }

  Scene scene;
  PreparedScene prepared;
  Occludees occludees;
};

Pieces of_box(Box const& b)
{
  return Pieces([&](SceneBuilder& s) { s.add(b); });
}

void add_triangle(SceneBuilder& s, Point3d const& a, Point3d const& b, Point3d const& c)
{
  s.add_triangle(s.add_vertex(a), s.add_vertex(b), s.add_vertex(c));
}

}  // namespace

TEST_CASE("occludees: faces that look up, and vertical ones", "[scene]")
{
  SECTION("a box has a top and four walls; a flat one what is left of them")
  {
    Pieces const box = of_box({{0, 0, 0}, {1, 2, 3}});
    CHECK(box.tops() == 1);
    CHECK(box.walls() == 4);
    Pieces const plate = of_box({{0, 0, 3}, {1, 2, 3}});
    CHECK(plate.tops() == 1);
    CHECK(plate.walls() == 0);
    Pieces const fence = of_box({{0, 0, 0}, {0, 2, 3}});
    CHECK(fence.tops() == 0);
    CHECK(fence.walls() == 2);  // the same one from both sides
  }
  SECTION("a prism has the walls of its holes, none between its convex pieces")
  {
    Pieces const ring([](SceneBuilder& s) {
      s.add(Prism{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}}, 0, 2});
    });
    CHECK(ring.walls() == 8);
    CHECK(ring.tops() > 1);
  }
  SECTION("of a convex solid what looks down is left out")
  {
    std::vector<Point3d> const octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    Pieces const solid([&](SceneBuilder& s) { s.add(ConvexPolyhedron::hull(octahedron)); });
    CHECK(solid.tops() == 4);
    CHECK(solid.walls() == 0);
  }
  SECTION("triangles are all kept, but for those without area")
  {
    Pieces const mesh([](SceneBuilder& s) {
      add_triangle(s, {0, 0, 0}, {1, 0, 0}, {0, 1, 5});
      add_triangle(s, {0, 0, 0}, {0, 1, 5}, {1, 0, 0});  // looks down
      add_triangle(s, {0, 0, 0}, {1, 1, 0}, {0, 0, 4});  // vertical
      add_triangle(s, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
      add_triangle(s, {0, 0, 0}, {0, 0, 1}, {0, 0, 2});
    });
    CHECK(mesh.tops() == 2);
    CHECK(mesh.walls() == 1);
    auto const& wall = *std::ranges::find_if(mesh.occludees.pieces(), &Occludees::Piece::is_wall);
    auto const boundary = mesh.occludees.upper_boundary(wall);
    CHECK(std::vector(boundary.begin(), boundary.end()) == std::vector<Point3d>{{0, 0, 4}, {1, 1, 0}});
  }
  SECTION("balls are refused")
  {
    CHECK_THROWS_AS(Pieces([](SceneBuilder& s) { s.add(Ball{{0, 0, 0}, 1}); }), BadInput);
  }
}

TEST_CASE("exposed lines: a tower that stands on half a plate covers its side, and has a seam on it", "[scene]")
{
  // A plate of 4 x 4 at height 1; the tower covers x > 2.
  Pieces const plate = of_box({{0, 0, 1}, {4, 4, 1}});
  Scene const tower = Pieces::built([](SceneBuilder& s) { s.add(Box{{2, -1, 0}, {5, 5, 9}}); });
  HeightField const field(tower);
  auto const length = [](std::vector<ExposedLine> const& lines) {
    double sum = 0;
    for (auto const& l : lines)
      sum +=
        std::hypot(CGAL::to_double(l.part.right.x - l.part.left.x), CGAL::to_double(l.part.right.y - l.part.left.y));
    return sum;
  };
  // Just before or just behind a side: 4 + 2 + 2 are exposed, each in both ways.
  auto const sides = exposed_sides(field, plate.occludees, 0);
  CHECK(length(sides) == 16);
  auto const seams = exposed_seams(field, plate.occludees, 0);
  CHECK(length(seams) == 4);
  for (auto const& s : seams) {
    CHECK(s.part.left.x == 2);
    CHECK(s.inside.x == 0);
  }
  std::vector<Point3d> const open{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
    covered{{3, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, 1, 0}};
  CHECK(is_exposed_inside(field, plate.occludees, 0, sides, open));
  CHECK(!is_exposed_inside(field, plate.occludees, 0, sides, covered));
}
