#include "height_fields.hpp"

#include "support/catch.hpp"
#include "support/trials.hpp"

#include "visibility/scene/exposed_parts.hpp"
#include "visibility/scene/generators.hpp"

#include <map>
#include <set>

using namespace visibility;
using namespace visibility::test;

namespace {

using NT = RationalNumber;
using Parts = std::vector<OpenInterval>;
Parts const nothing{};

/// What is exposed of an edge of object 0: the whole of it is the part (0, 1).
Parts exposed(std::vector<Shape> const& shapes, Point3d const& a, Point3d const& b, Crossing crossing)
{
  Scene const scene = scene_of(shapes);
  HeightField const field(scene);
  auto const result = exposed_parts(field, edge_at(field, 0, a, b), crossing);
  if (result.all) REQUIRE(result.parts.empty());
  return result.all ? Parts{{NT(0), NT(1)}} : result.parts;
}
Parts const whole{{NT(0), NT(1)}};

/// The edge of all hand cases: the side y = 0 of the box [0, 10] x [0, 4], 5 high. Entered from below, in plan.
Shape const house = box(0, 0, 10, 4, 5);
Parts entering(std::vector<Shape> others)
{
  others.insert(others.begin(), house);
  return exposed(others, {0, 0, 5}, {10, 0, 5}, Crossing::entering);
}
Parts leaving(std::vector<Shape> others)
{
  others.insert(others.begin(), house);
  return exposed(others, {0, 0, 5}, {10, 0, 5}, Crossing::leaving);
}
/// A quadrilateral over [x0, x1] x [y0, y1] whose height is that of the plane z0 + gx x + gy y.
Shape slope(double x0, double y0, double x1, double y1, double z0, double gx, double gy)
{
  auto const at = [&](double x, double y) { return Point3d{x, y, z0 + gx * x + gy * y}; };
  return mesh({triangle(at(x0, y0), at(x1, y0), at(x1, y1)), triangle(at(x0, y0), at(x1, y1), at(x0, y1))});
}

/// A point of an edge, and one a tiny step to the side from which the crossing is covered.
struct Beside {
  NT height;
  Point2q at;
  Beside(HeightField::TopEdge const& e, Crossing crossing, NT const& t)
  {
    auto const a = exact(e.a), b = exact(e.b);
    NT const step = crossing == Crossing::entering ? NT(0x1p-200) : NT(-0x1p-200);
    height = a.z + t * (b.z - a.z);
    at = {a.x + t * (b.x - a.x) + step * (b.y - a.y), a.y + t * (b.y - a.y) - step * (b.x - a.x)};
  }
};

/// The definition at one point: a column that contains the points just in front of the wall point just below the edge,
/// or, leaving, one that is higher than the edge's column just before the edge.
bool exposed_at(HeightField const& field, std::uint32_t edge, Crossing crossing, NT const& t)
{
  auto const& e = field.edges()[edge];
  auto const& own = field.columns()[e.column];
  Beside const p(e, crossing, t);
  bool const sees_top = crossing == Crossing::leaving && !own.is_curtain();
  for (auto const& f : field.columns()) {
    if (&f == &own || f.is_curtain() || !contains(field, f, p.at)) continue;
    NT const top = top_over(field, f, p.at);
    if (sees_top ? top > top_over(field, own, p.at) : top >= p.height - NT(0x1p-100)) return false;
  }
  return true;
}

/// What is exposed of every edge, by object, column, edge and crossing. Columns that coincide must agree.
using Coordinates = std::array<double, 3>;
using Table = std::map<std::tuple<std::string, std::set<Coordinates>, Coordinates, Coordinates, Crossing>, Parts>;
Table table(HeightField const& field)
{
  auto const plain = [](Point3d const& p) { return Coordinates{p.x, p.y, p.z}; };
  Table out;
  for (std::uint32_t i = 0; i < field.edges().size(); ++i)
    for (auto const crossing : {Crossing::entering, Crossing::leaving}) {
      auto const& [a, b, column] = field.edges()[i];
      auto const& c = field.columns()[column];
      std::set<Coordinates> corners;
      for (auto const& p : field.corners(c)) corners.insert(plain(p));
      auto const result = exposed_parts(field, i, crossing);
      auto const [at, is_new] =
        out.try_emplace({field.scene().objects[c.object].name, corners, plain(a), plain(b), crossing},
                        result.all ? whole : result.parts);
      REQUIRE(at->second == (result.all ? whole : result.parts));
    }
  return out;
}
/// Compares what both tables have; returns how many edges that were.
int compare_common(Table const& x, Table const& y)
{
  int common = 0;
  for (auto const& [edge, parts] : x)
    if (auto const found = y.find(edge); found != y.end()) {
      REQUIRE(found->second == parts);
      ++common;
    }
  return common;
}

}  // namespace

TEST_CASE("exposed parts: a neighbour in front buries the wall unless it is lower", "[scene]")
{
  REQUIRE(entering({}) == whole);
  REQUIRE(entering({box(0, -3, 10, 0, 4)}) == whole);
  REQUIRE(entering({box(0, -3, 10, 0, 5)}) == nothing);
  REQUIRE(entering({box(0, -3, 10, 0, 6)}) == nothing);
  REQUIRE(entering({box(0, -3, 10, -1, 6)}) == whole);   // not at the edge
  REQUIRE(entering({box(-5, -3, 0, 0, 6)}) == whole);    // at its corner
  REQUIRE(entering({box(10, -3, 12, 4, 6)}) == whole);   // beside it
  REQUIRE(entering({box(0, 0, 10, 8, 6)}) == whole);     // behind the same wall
  REQUIRE(entering({box(0, -3, 10, 8, 6)}) == nothing);  // around it
  REQUIRE(entering({box(2, 1, 8, 3, 6)}) == whole);      // a tower on the roof
}

TEST_CASE("exposed parts: partly covered walls keep the rest, in order", "[scene]")
{
  REQUIRE(entering({box(2, -3, 5, 0, 5)}) == Parts{{NT(0), NT(1, 5)}, {NT(1, 2), NT(1)}});
  REQUIRE(entering({box(-2, -3, 5, 0, 5)}) == Parts{{NT(1, 2), NT(1)}});
  REQUIRE(entering({box(5, -3, 12, 0, 5)}) == Parts{{NT(0), NT(1, 2)}});
  REQUIRE(entering({box(5, -3, 7, 0, 5), box(1, -3, 5, 0, 7)}) == Parts{{NT(0), NT(1, 10)}, {NT(7, 10), NT(1)}});
  REQUIRE(entering({box(5, -3, 7, 1, 5), box(1, -3, 6, 0, 4)}) == Parts{{NT(0), NT(1, 2)}, {NT(7, 10), NT(1)}});
  // A slanted footprint that crosses the wall from x = 1 to x = 4, and one that only touches it with a corner.
  REQUIRE(entering({prism({{{0, -1}, {2, -3}, {5, 1}, {3, 2}}}, 9)}) == Parts{{NT(0), NT(1, 10)}, {NT(17, 40), NT(1)}});
  REQUIRE(entering({prism({{{4, -2}, {6, -2}, {5, 0}}}, 9)}) == whole);
  REQUIRE(entering({prism({{{4, 2}, {5, 0}, {6, 2}}}, 9)}) == whole);
}

TEST_CASE("exposed parts: a top is covered by what stands on it higher, not by an equal one", "[scene]")
{
  REQUIRE(leaving({}) == whole);
  REQUIRE(leaving({house}) == whole);  // coinciding: both visible
  REQUIRE(entering({house}) == whole);
  REQUIRE(leaving({box(-1, -1, 11, 5, 5)}) == whole);  // equal top around it
  REQUIRE(entering({box(-1, -1, 11, 5, 5)}) == nothing);
  REQUIRE(leaving({box(-1, -1, 11, 5, 6)}) == nothing);
  REQUIRE(leaving({box(-1, -1, 11, 5, 4)}) == whole);
  REQUIRE(leaving({box(0, -3, 10, 0, 9)}) == whole);  // in front of the edge only
  REQUIRE(leaving({box(2, 0, 5, 2, 9)}) == Parts{{NT(0), NT(1, 5)}, {NT(1, 2), NT(1)}});
  REQUIRE(leaving({box(2, 1, 5, 2, 9)}) == whole);  // further in
}

TEST_CASE("exposed parts: slanted tops cover where they are higher, or rise", "[scene]")
{
  REQUIRE(entering({slope(0, -4, 10, 0, 0, 1, 0)}) == Parts{{NT(0), NT(1, 2)}});
  REQUIRE(entering({slope(0, -4, 10, 0, 10, -1, 0)}) == Parts{{NT(1, 2), NT(1)}});
  REQUIRE(entering({slope(0, -4, 10, 0, 5, 0, 1)}) == nothing);  // as high at the edge, falling away from it
  REQUIRE(entering({slope(0, -4, 10, 0, 4, 0, -1)}) == whole);   // lower at the edge, higher further off
  REQUIRE(leaving({slope(0, 0, 10, 4, 5, 0, 1)}) == nothing);    // touches the edge and rises inwards
  REQUIRE(leaving({slope(0, 0, 10, 4, 5, 0, -1)}) == whole);     // touches the edge and falls inwards
  REQUIRE(leaving({slope(0, 0, 10, 4, 3, 0.5, 1)}) == Parts{{NT(0), NT(2, 5)}});
  REQUIRE(leaving({slope(0, 0, 10, 4, 5, 1, 0)}) == nothing);  // touches one corner, higher elsewhere
  REQUIRE(leaving({slope(0, 0, 10, 4, 5, -1, 0)}) == whole);
}

TEST_CASE("exposed parts: a roof of two slopes covers its neighbour's wall at the ridge it shares", "[scene]")
{
  Triangle const left = triangle({0, 0, 4}, {10, 0, 4}, {5, 5, 1});
  Triangle const right = triangle({0, 0, 4}, {10, 0, 4}, {5, -5, 1});
  auto const ridge = [&](Crossing c) { return exposed({mesh({left, right})}, {0, 0, 4}, {10, 0, 4}, c); };
  REQUIRE(ridge(Crossing::entering) == nothing);  // columns of the same object count
  REQUIRE(ridge(Crossing::leaving) == whole);
}

TEST_CASE("exposed parts: a curtain is entered from either side and covers nothing", "[scene]")
{
  Shape const wall = mesh({triangle({0, 0, 5}, {10, 0, 5}, {0, 0, 0})});
  auto const wall_exposed = [&](std::vector<Shape> others, Crossing c) {
    others.insert(others.begin(), wall);
    return exposed(others, {0, 0, 5}, {10, 0, 5}, c);
  };
  for (auto const c : {Crossing::entering, Crossing::leaving}) REQUIRE(wall_exposed({wall}, c) == whole);
  REQUIRE(wall_exposed({house}, Crossing::leaving) == nothing);  // equal height buries it
  REQUIRE(wall_exposed({house}, Crossing::entering) == whole);
  REQUIRE(wall_exposed({box(0, -4, 5, 0, 5)}, Crossing::entering) == Parts{{NT(1, 2), NT(1)}});
  REQUIRE(wall_exposed({box(0, -4, 5, 0, 5)}, Crossing::leaving) == whole);
  REQUIRE(entering({mesh({triangle({0, 0, 9}, {10, 0, 9}, {0, 0, 0})})}) == whole);
  REQUIRE(leaving({mesh({triangle({5, -1, 9}, {5, 3, 9}, {5, 0, 0})})}) == whole);
}

TEST_CASE("exposed parts: inside a part iff no column covers the point", "[scene][oracle]")
{
  int covered = 0, partly = 0, points = 0;
  for (int seed = 1; seed <= trials(60); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    Scene const scene = scene_of(random_shapes(random, random.between(2, 12), random.between(3, 8)));
    HeightField const field(scene);
    for (std::uint32_t i = 0; i < field.edges().size(); ++i)
      for (auto const crossing : {Crossing::entering, Crossing::leaving}) {
        auto const result = exposed_parts(field, i, crossing);
        auto const reference = exposed_parts<Rational>(field, i, crossing);
        REQUIRE(result.all == reference.all);
        REQUIRE(result.parts == reference.parts);
        covered += !result.all && result.parts.empty();
        partly += !result.parts.empty();
        NT last(-1);
        for (auto const& [low, high] : result.parts) {
          REQUIRE(last < low);  // maximal: a closed interval or point lies between two parts
          REQUIRE(low < high);
          last = high;
        }
        REQUIRE(last <= 1);
        // Denominators that no end of a part has.
        for (int k = 0; k < 5; ++k, ++points) {
          NT const t(random.between(1, 10'006), 10'007);
          bool const inside = result.all || std::ranges::any_of(result.parts, [&](OpenInterval const& p) {
                                return p.low < t && t < p.high;
                              });
          CAPTURE(i, int(crossing), CGAL::to_double(t));
          REQUIRE(inside == exposed_at(field, i, crossing, t));
        }
      }
  }
  REQUIRE(covered > 100);
  REQUIRE(partly > 100);
}

TEST_CASE("exposed parts: laws of order, rotation and split", "[scene][law]")
{
  int common = 0;
  for (int seed = 1; seed <= trials(60); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed) + 1000);
    auto const shapes = random_shapes(random, random.between(2, 10), random.between(3, 6));
    Scene const scene = scene_of(shapes);
    HeightField const field(scene);
    Table const expected = table(field);

    Scene reversed = scene;
    std::ranges::reverse(reversed.objects);
    REQUIRE(compare_common(expected, table(HeightField(reversed))) == static_cast<int>(expected.size()));

    Scene rotated = scene;
    for (auto& t : rotated.triangles) std::ranges::rotate(t, t.begin() + random.below(3));
    REQUIRE(compare_common(expected, table(HeightField(rotated))) == static_cast<int>(expected.size()));

    // Boxes and triangles cut in two; the edges of the other objects, and the uncut ones of these, stay what they are.
    auto split = shapes;
    for (auto& shape : split) {
      if (random.chance(0.3)) continue;
      for (std::size_t i = 0, n = shape.boxes.size(); i < n; ++i) {
        double const x = shape.boxes[i].min.x + 1;
        shape.boxes.push_back(shape.boxes[i]);
        shape.boxes[i].max.x = shape.boxes.back().min.x = x;
      }
      for (std::size_t i = 0, n = shape.triangles.size(); i < n; ++i) {
        auto& [a, b, c] = shape.triangles[i].vertices;
        Point3d const m{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
        shape.triangles.push_back({{m, b, c}});
        shape.triangles[i].vertices[1] = m;
      }
    }
    Scene const cut = scene_of(split);
    common += compare_common(expected, table(HeightField(cut)));
  }
  REQUIRE(common > 1000);
}

TEST_CASE("exposed parts: in a city of separate boxes every edge is exposed but where towers stand flush", "[scene]")
{
  Scene const scene = generate("city,n=400");
  HeightField const field(scene);
  for (std::uint32_t i = 0; i < field.edges().size(); ++i)
    for (auto const crossing : {Crossing::entering, Crossing::leaving}) REQUIRE(exposed_parts(field, i, crossing).all);
}
