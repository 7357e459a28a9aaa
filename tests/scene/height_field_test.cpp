#include "height_fields.hpp"
#include "meshes.hpp"

#include "support/catch.hpp"
#include "support/real_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/read_scene.hpp"

#include <set>

using namespace visibility;
using namespace visibility::test;

namespace {

using NT = RationalNumber;
using Coordinates = std::array<double, 6>;
using Edges = std::multiset<Coordinates>;

Edges edges_of(HeightField const& field)
{
  Edges out;
  for (auto const& [a, b, column] : field.edges()) out.insert({a.x, a.y, a.z, b.x, b.y, b.z});
  return out;
}
Edges edges_of(Shape const& shape)
{
  Scene const scene = scene_of({shape});
  return edges_of(HeightField(scene));
}
/// The sides of a ring, with the area to the left, at one height.
void append(Edges& edges, Ring const& ring, double z)
{
  for (std::size_t i = 0; i < ring.size(); ++i) {
    auto const &p = ring[i], &q = ring[(i + 1) % ring.size()];
    edges.insert({p.x, p.y, z, q.x, q.y, z});
  }
}
Edges outline(std::vector<Ring> const& rings, double z)
{
  Edges edges;
  for (auto const& r : rings) append(edges, r, z);
  return edges;
}

/// What every height field promises.
void check(HeightField const& field)
{
  std::uint32_t last = 0;
  std::vector<Box> bounds;
  for (auto const& c : field.columns()) {
    REQUIRE(c.object >= last);
    last = c.object;
    auto const corners = field.corners(c);
    REQUIRE((corners.size() == c.count && c.count >= 2));
    REQUIRE(c.is_flat == std::ranges::all_of(corners, [&](Point3d const& p) { return p.z == corners[0].z; }));
    if (!c.is_flat) REQUIRE(c.count <= 3);
    Box& b = bounds.emplace_back();
    for (auto const& p : corners) b.extend(p);
    b.min.z = std::min(HeightField::bottomless, 2 * b.min.z);
  }
  field.column_hierarchy().validate(bounds);
  bounds.clear();
  last = 0;
  for (auto const& e : field.edges()) {
    REQUIRE(e.column >= last);
    last = e.column;
    REQUIRE(!(horizontal(e.a) == horizontal(e.b)));
    bounds.emplace_back().extend(e.a);
    bounds.back().extend(e.b);
    bounds.back().min.z = std::min(HeightField::bottomless, 2 * bounds.back().min.z);
    for (auto const& p : field.corners(field.columns()[e.column]))  // convex, and to the left
      REQUIRE(!is_negative(orient2d<Filtered>(horizontal(e.a), horizontal(e.b), horizontal(p))));
  }
  field.edge_hierarchy().validate(bounds);
  for (std::uint32_t i = 0; i < field.columns().size(); ++i)
    if (field.columns()[i].is_curtain())
      REQUIRE(std::ranges::binary_search(field.edges(), i, {}, &HeightField::TopEdge::column));
}

/// A line in space over a segment of the plan, p + t (q - p).
struct Line {
  Point3q p, q;
  /// Signed area between the line in plan and a point.
  NT side(Point3d const& r) const { return (q.x - p.x) * (NT(r.y) - p.y) - (q.y - p.y) * (NT(r.x) - p.x); }
  Point2q at(NT const& t) const { return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; }
  NT height(NT const& t) const { return p.z + t * (q.z - p.z); }
};

/// Whether the line is above a -> b where it crosses it in plan, if it does.
bool is_above(Line const& line, Point3d const& a, Point3d const& b)
{
  NT const sa = line.side(a), sb = line.side(b);
  if (sa * sb >= 0) return true;  // lines through corners do not occur
  NT const s = sa / (sa - sb);
  NT const x = NT(a.x) + s * (NT(b.x) - NT(a.x)), y = NT(a.y) + s * (NT(b.y) - NT(a.y));
  NT const t = line.q.x != line.p.x ? (x - line.p.x) / (line.q.x - line.p.x) : (y - line.p.y) / (line.q.y - line.p.y);
  return line.height(t) > NT(a.z) + s * (NT(b.z) - NT(a.z));
}

bool is_above(Line const& line, HeightField const& field, HeightField::Column const& column)
{
  auto const c = field.corners(column);
  for (std::size_t i = 0; i < c.size(); ++i)
    if (!is_above(line, c[i], c[(i + 1) % c.size()])) return false;
  return true;
}

}  // namespace

TEST_CASE("height field: a box is a column with four edges, counterclockwise", "[scene]")
{
  REQUIRE(edges_of(box(1, 2, 4, 6, 5)) == outline({{{1, 2}, {4, 2}, {4, 6}, {1, 6}}}, 5));
  REQUIRE(edges_of(box(1, 2, 4, 6, 5, 5)) == edges_of(box(1, 2, 4, 6, 5)));       // no height
  REQUIRE(edges_of(box(1, 2, 1, 6, 5)) == Edges{Coordinates{1, 2, 5, 1, 6, 5}});  // no width: a curtain
  REQUIRE(edges_of(box(1, 2, 1, 2, 5)).empty());
  Shape tower = box(0, 0, 9, 9, 3);
  tower.boxes.push_back({{2, 2, 3}, {7, 7, 6}});
  Edges expected = outline({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}, 3);
  append(expected, {{2, 2}, {7, 2}, {7, 7}, {2, 7}}, 6);
  REQUIRE(edges_of(tower) == expected);
}

TEST_CASE("height field: of a prism only the outline remains", "[scene]")
{
  for (int kind = 0; kind < plan_kinds; ++kind)
    REQUIRE(edges_of(prism({plan_of(kind)}, 7)) == outline({plan_of(kind)}, 7));
  Ring const hole{{2, 2}, {2, 6}, {6, 6}, {6, 2}}, court{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  REQUIRE(edges_of(prism({court, hole}, 7)) == outline({court, hole}, 7));
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    auto const ring = star(random, random.between(3, 40), 2, 20);
    REQUIRE(edges_of(prism({ring}, 4)) == outline({ring}, 4));
  }
}

TEST_CASE("height field: a prism whose outline crosses itself is its walls", "[scene][degenerate]")
{
  Scene const scene = scene_of({prism({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, 3)});
  HeightField const field(scene);
  check(field);
  REQUIRE(field.invalid_footprints() == 1);
  REQUIRE(field.edges().size() == 4);
  for (auto const& c : field.columns()) REQUIRE(c.is_curtain());
}

TEST_CASE("height field: an edge that two triangles share remains iff it is a ridge", "[scene]")
{
  auto const edges = [](double z) {
    return edges_of(mesh({triangle({0, 0, 4}, {9, 0, 4}, {3, 5, 4}), triangle({9, 0, 4}, {0, 0, 4}, {6, -5, z})}))
      .size();
  };
  REQUIRE(edges(4) == 4);  // flat
  REQUIRE(edges(5) == 4);  // valley
  REQUIRE(edges(3) == 6);  // ridge: an edge of either column
  // Both on one side of it: nothing is shared.
  REQUIRE(
    edges_of(mesh({triangle({0, 0, 4}, {9, 0, 4}, {3, 5, 4}), triangle({0, 0, 4}, {9, 0, 4}, {6, 5, 4})})).size() == 6);
}

TEST_CASE("height field: a ridge between a flat roof with straight corners and a slope remains on both sides",
          "[scene][regression]")
{
  Shape house = prism({{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}}}, 5);
  house.triangles = {triangle({0, 10, 5}, {10, 10, 5}, {5, 15, 1})};
  auto const edges = edges_of(house);
  REQUIRE(edges.contains({10, 10, 5, 0, 10, 5}));
  REQUIRE(edges.contains({0, 10, 5, 10, 10, 5}));
}

TEST_CASE("height field: the orientation of triangles does not matter", "[scene]")
{
  auto const up = triangle({0, 0, 1}, {9, 0, 2}, {3, 5, 3}), down = triangle({0, 0, 1}, {3, 5, 3}, {9, 0, 2});
  REQUIRE(edges_of(mesh({up})) == edges_of(mesh({down})));
}

TEST_CASE("height field: a convex solid gives its upper facets", "[scene]")
{
  Shape solid;
  solid.polyhedra.push_back(ConvexPolyhedron::from_box({{1, 2, 0}, {4, 6, 5}}));
  REQUIRE(edges_of(solid) == edges_of(box(1, 2, 4, 6, 5)));
}

TEST_CASE("height field: a vertical triangle is the curtains below its upper boundary", "[scene]")
{
  auto const upright = [](double z) { return edges_of(mesh({triangle({0, 0, 2}, {8, 0, 2}, {4, 0, z})})); };
  REQUIRE(upright(5) == Edges{Coordinates{0, 0, 2, 4, 0, 5}, Coordinates{4, 0, 5, 8, 0, 2}});
  REQUIRE(upright(1) == Edges{Coordinates{0, 0, 2, 8, 0, 2}});
  REQUIRE(edges_of(mesh({triangle({0, 0, 2}, {0, 8, 2}, {0, 0, 6})})) == Edges{Coordinates{0, 0, 6, 0, 8, 2}});
  REQUIRE(edges_of(mesh({triangle({0, 0, 2}, {0, 0, 3}, {0, 0, 6})})).empty());
}

TEST_CASE("height field: walls and floor of a closed mesh leave no edges of their own", "[scene]")
{
  auto const ring = plan_of(0);
  REQUIRE(edges_of(mesh(extrusion(ring, 0, 7))) == outline({ring}, 7));
  Scene const scene = scene_of({mesh(extrusion(ring, 0, 7))});
  REQUIRE(HeightField(scene).columns().size() == 8);  // roof and floor
  // A wall that is higher than the roof it carries remains, and its roof below it.
  Shape parapet = box(0, 0, 8, 8, 5);
  parapet.triangles = {triangle({0, 0, 5}, {8, 0, 5}, {8, 0, 6}), triangle({0, 0, 5}, {8, 0, 6}, {0, 0, 6})};
  REQUIRE(edges_of(parapet).contains({0, 0, 6, 8, 0, 6}));
}

TEST_CASE("height field: balls are refused by name; what hangs in the air is counted", "[scene]")
{
  SceneBuilder builder("test");
  builder.begin_object("moon");
  builder.add(Ball{{0, 0, 0}, 1});
  Scene const moon = builder.finish();
  REQUIRE_THROWS_AS(HeightField(moon), BadInput);
  REQUIRE_THROWS_WITH(HeightField(moon), Catch::Contains("moon"));
  Scene const scene = scene_of({box(0, 0, 1, 1, 5, 1), box(2, 0, 3, 1, 5, 2), box(4, 0, 5, 1, 5, 1)});
  HeightField const field(scene);
  REQUIRE(field.ground() == 1);
  REQUIRE(field.raised() == 1);
}

TEST_CASE("height field: above all edges is above all columns", "[scene][oracle]")
{
  int above = 0, below = 0;
  for (int seed = 1; seed <= trials(150); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    int const n = random.between(3, 6);
    Scene const scene = scene_of(random_shapes(random, random.between(1, 6), n));
    HeightField const field(scene);
    check(field);
    auto const end = [&](NT const& x) {
      return Point3q{x, NT(2 * n + 2) * NT(random.between(1, 10'006), 10'007) - 1,
                     NT(5 * n) * NT(random.between(1, 96), 97)};
    };
    for (int k = 0; k < 60; ++k) {
      Line const line{end(NT(-1, 3)), end(NT(2 * n) + NT(1, 3))};
      bool const columns =
        std::ranges::all_of(field.columns(), [&](auto const& c) { return is_above(line, field, c); });
      bool const edges = std::ranges::all_of(field.edges(), [&](auto const& e) { return is_above(line, e.a, e.b); });
      REQUIRE(edges == columns);
      ++(columns ? above : below);
    }
  }
  REQUIRE(above > 100);
  REQUIRE(below > 100);
}

TEST_CASE("height field: generated scenes", "[scene]")
{
  for (auto const* kind : {"city,n=100", "slanted,n=50", "district"}) {
    CAPTURE(kind);
    Scene const scene = generate(kind);
    HeightField const field(scene);
    check(field);
    // Windows of the district stand back below their lintels.
    REQUIRE((field.raised() == 0) == (kind != std::string("district")));
  }
  Scene const scene = generate("slanted,n=50");
  HeightField const field(scene);
  REQUIRE(field.edges().size() == 50 * 6);  // four sides, and the ridge twice
}

TEST_CASE("height field: real scenes", "[scene]")
{
  for (auto const* name : {"city/munich.ply", "city/lyon1.geojson", "cityjson/cjio_zurich_subset_lod2.json"}) {
    auto const path = real_scene(name);
    if (!path) continue;
    CAPTURE(name);
    Scene const scene = read_scene(*path);
    HeightField const field(scene);
    check(field);
    REQUIRE(field.edges().size() > scene.objects.size());
  }
}
