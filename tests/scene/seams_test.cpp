#include "seams.hpp"

#include "support/catch.hpp"
#include "support/trials.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

using NT = RationalNumber;
using Ends = std::set<PartEnds>;

/// The roof of all hand cases: 10 x 10, 5 high. The parts of its seams with another object.
Shape const roof = box(0, 0, 10, 10, 5);
Ends parts_on(Shape const& first, std::vector<Shape> others, std::uint32_t other = 1)
{
  others.insert(others.begin(), first);
  Scene const scene = scene_of(others);
  HeightField const field(scene);
  REQUIRE(field.seam_bounds().size() == field.seams().size());
  Ends out;
  for (auto const& s : field.seams())
    if (field.columns()[s.column].object == 0 && field.columns()[s.other].object == other)
      for (auto const& p : exposed_parts(field, s)) REQUIRE(out.insert(ends(p)).second);
  return out;
}
Ends on_roof(std::vector<Shape> others, std::uint32_t other = 1) { return parts_on(roof, std::move(others), other); }

/// A part at height 5.
PartEnds at_5(int x0, int y0, int x1, int y1) { return {NT(x0), NT(y0), NT(5), NT(x1), NT(y1), NT(5)}; }

/// A quadrilateral over [x0, x1] x [y0, y1] whose height is that of the plane z0 + gx x + gy y.
Shape slope(double x0, double y0, double x1, double y1, double z0, double gx, double gy)
{
  auto const at = [&](double x, double y) { return Point3d{x, y, z0 + gx * x + gy * y}; };
  return mesh({triangle(at(x0, y0), at(x1, y0), at(x1, y1)), triangle(at(x0, y0), at(x1, y1), at(x0, y1))});
}
Shape curtain(Point3d const& a, Point3d const& b) { return mesh({triangle(a, b, {a.x, a.y, a.z - 20})}); }

Shape const tower = box(3, 4, 6, 7, 9);

/// Cuts boxes and triangles in two.
void cut(Shape& shape)
{
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

}  // namespace

TEST_CASE("seams: a tower has a foot on every side that stands on the roof", "[scene]")
{
  PartEnds const front = at_5(3, 4, 6, 4), right = at_5(6, 4, 6, 7), back = at_5(6, 7, 3, 7), left = at_5(3, 7, 3, 4);
  REQUIRE(on_roof({tower}) == Ends{front, right, back, left});
  REQUIRE(on_roof({box(3, 4, 6, 10, 9)}) == Ends{front, at_5(6, 4, 6, 10), at_5(3, 10, 3, 4)});  // flush with the wall
  REQUIRE(on_roof({box(3, 4, 6, 12, 9)}) == Ends{front, at_5(6, 4, 6, 10), at_5(3, 10, 3, 4)});
  REQUIRE(on_roof({box(6, 4, 12, 12, 9)}) == Ends{at_5(6, 4, 10, 4), at_5(6, 10, 6, 4)});
  REQUIRE(on_roof({box(-1, 4, 11, 12, 9)}) == Ends{at_5(0, 4, 10, 4)});
  REQUIRE(on_roof({box(-1, -1, 11, 11, 9)}).empty());
  REQUIRE(parts_on(tower, {roof}).empty());  // the tower's top ends at its own sides only
}

TEST_CASE("seams: none where tops do not meet inside the roof", "[scene]")
{
  REQUIRE(on_roof({box(3, 4, 6, 7, 4)}).empty());
  REQUIRE(on_roof({box(3, 4, 6, 7, 5)}).empty());
  REQUIRE(on_roof({box(3, 4, 16, 17, 5)}).empty());
  REQUIRE(on_roof({roof}).empty());
  REQUIRE(on_roof({box(10, 0, 20, 10, 9)}).empty());  // abutting
  REQUIRE(on_roof({box(0, -5, 10, 0, 9)}).empty());
  REQUIRE(on_roof({box(10, 10, 12, 12, 9)}).empty());
  REQUIRE(on_roof({prism({{{11, 4}, {13, 2}, {12, 9}}}, 9)}).empty());   // boxes apart
  REQUIRE(on_roof({prism({{{9, 12}, {12, 9}, {12, 12}}}, 9)}).empty());  // boxes overlap
  Scene const one = scene_of({{{roof.boxes[0], tower.boxes[0]}, {}, {}, {}}});
  REQUIRE(HeightField(one).seams().empty());  // the same object
}

TEST_CASE("seams: what stands in front of a foot covers it", "[scene]")
{
  PartEnds const right = at_5(6, 4, 6, 7), back = at_5(6, 7, 3, 7), left = at_5(3, 7, 3, 4);
  auto const with = [&](Shape const& g) { return on_roof({tower, g}); };
  REQUIRE(with(box(2, 2, 4, 4, 7)) == Ends{at_5(4, 4, 6, 4), right, back, left});
  REQUIRE(with(box(4, 2, 5, 4, 7)) == Ends{at_5(3, 4, 4, 4), at_5(5, 4, 6, 4), right, back, left});
  REQUIRE(with(box(2, 2, 4, 5, 7)) == Ends{at_5(4, 4, 6, 4), right, back, at_5(3, 7, 3, 5)});
  REQUIRE(with(box(2, 2, 8, 9, 7)).empty());
  REQUIRE(with(box(2, 2, 8, 9, 5)).size() == 4);                          // coinciding tops
  REQUIRE(with(box(3, 2, 6, 3, 7)).size() == 4);                          // further off
  REQUIRE(with(curtain({2, 4, 9}, {8, 4, 9})).size() == 4);               // without width
  REQUIRE(with(slope(3, 2, 6, 4, 9, 0, -1)) == Ends{right, back, left});  // as high at the foot, rising off it
  REQUIRE(with(slope(3, 2, 6, 4, 1, 0, 1)).size() == 4);                  // falling off it
  REQUIRE(with(slope(3, 2, 7, 4, 0.5, 1, 0)) == Ends{{NT(3), NT(4), NT(5), NT(9, 2), NT(4), NT(5)}, right, back, left});
  // A column of the roof's object covers as well.
  Shape const raised{{roof.boxes[0], Box{{2, 2, 0}, {4, 4, 7}}}, {}, {}, {}};
  REQUIRE(parts_on(raised, {tower}) == Ends{at_5(4, 4, 6, 4), right, back, left});
}

TEST_CASE("seams: creases where slanted tops cross", "[scene]")
{
  Shape const up = slope(0, 0, 10, 10, 0, 1, 0), down = slope(0, 0, 10, 10, 10, -1, 0);
  REQUIRE(parts_on(up, {down}) == Ends{at_5(5, 0, 5, 5), at_5(5, 5, 5, 10)});
  REQUIRE(parts_on(down, {up}) == Ends{at_5(5, 5, 5, 0), at_5(5, 10, 5, 5)});
  REQUIRE(on_roof({up}) == Ends{at_5(5, 5, 5, 0), at_5(5, 10, 5, 5)});
  REQUIRE(parts_on(up, {down, box(1, 1, 9, 4, 8)}) == Ends{at_5(5, 0, 5, 1), at_5(5, 4, 5, 5), at_5(5, 5, 5, 10)});
  REQUIRE(parts_on(up, {up}).empty());
  REQUIRE(parts_on(up, {slope(0, 0, 10, 10, 1, 1, 0)}).empty());
  // A ramp that starts on the roof: a crease along its side, and three feet.
  REQUIRE(on_roof({slope(2, 2, 4, 4, 3, 1, 0)}) ==
          Ends{at_5(2, 4, 2, 2), at_5(2, 2, 4, 2), at_5(4, 2, 4, 4), at_5(4, 4, 2, 4)});
  REQUIRE(on_roof({slope(2, 2, 4, 4, 7, -1, 0)}).empty());
}

TEST_CASE("seams: feet end where the edge sinks into a slanted roof", "[scene]")
{
  Shape const up = slope(0, 0, 10, 10, 0, 1, 0);
  REQUIRE(parts_on(up, {box(-1, 3, 11, 20, 6)}) == Ends{{NT(0), NT(3), NT(0), NT(3), NT(3), NT(3)},
                                                        {NT(3), NT(3), NT(3), NT(6), NT(3), NT(6)},
                                                        {NT(6), NT(3), NT(6), NT(6), NT(6), NT(6)},
                                                        {NT(6), NT(6), NT(6), NT(6), NT(10), NT(6)}});
}

TEST_CASE("seams: a curtain has a foot on both sides", "[scene]")
{
  REQUIRE(on_roof({curtain({2, 5, 9}, {8, 5, 9})}) == Ends{at_5(2, 5, 8, 5), at_5(8, 5, 2, 5)});
  REQUIRE(on_roof({curtain({2, 5, 3}, {8, 5, 7})}) == Ends{at_5(5, 5, 8, 5), at_5(8, 5, 5, 5)});
  REQUIRE(on_roof({curtain({-2, 5, 9}, {18, 5, 9})}) == Ends{at_5(0, 5, 10, 5), at_5(10, 5, 0, 5)});
  REQUIRE(on_roof({curtain({2, 5, 9}, {8, 5, 9}), box(4, 5, 6, 7, 8)}) ==
          Ends{at_5(2, 5, 8, 5), at_5(4, 5, 2, 5), at_5(8, 5, 6, 5)});
  REQUIRE(on_roof({curtain({2, 5, 5}, {8, 5, 5})}).empty());
  REQUIRE(on_roof({curtain({2, 0, 9}, {8, 0, 9})}).empty());    // along the wall
  REQUIRE(on_roof({curtain({-2, 2, 9}, {2, -2, 9})}).empty());  // at a corner
}

TEST_CASE("seams: a foot along a side that the object's columns share", "[scene]")
{
  Shape const two{{Box{{0, 0, 0}, {4, 10, 5}}, Box{{4, 0, 0}, {10, 10, 5}}}, {}, {}, {}};
  REQUIRE(parts_on(two, {box(4, 3, 7, 6, 9)}) ==
          Ends{at_5(4, 6, 4, 3), at_5(4, 3, 7, 3), at_5(7, 3, 7, 6), at_5(7, 6, 4, 6)});
  REQUIRE(parts_on(two, {curtain({4, 2, 9}, {4, 8, 9})}) == Ends{at_5(4, 2, 4, 8), at_5(4, 8, 4, 2)});
  REQUIRE(parts_on(two, {slope(4, 3, 6, 5, 1, 1, 0)}).count(at_5(4, 5, 4, 3)) == 1);  // a crease
  REQUIRE(parts_on(prism({{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}}, 5), {box(0, 4, 4, 7, 9)}) ==
          Ends{at_5(0, 4, 4, 4), at_5(4, 7, 0, 7)});
}

TEST_CASE("seams: laws of order, rotation and split", "[scene][law]")
{
  std::size_t seams = 0, kept = 0;
  for (int seed = 1; seed <= trials(40); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed) + 5000);
    auto const shapes = random_shapes(random, random.between(3, 10), random.between(3, 6));
    Scene const scene = scene_of(shapes);
    SeamTable const expected = seam_table(HeightField(scene));
    seams += expected.size();

    Scene reversed = scene;
    std::ranges::reverse(reversed.objects);
    REQUIRE(seam_table(HeightField(reversed)) == expected);
    Scene rotated = scene;
    for (auto& t : rotated.triangles) std::ranges::rotate(t, t.begin() + random.below(3));
    REQUIRE(seam_table(HeightField(rotated)) == expected);

    // Seams between objects that were not cut stay what they are.
    auto split = shapes;
    std::set<std::string> whole;
    for (std::size_t i = 0; i < split.size(); ++i)
      if (random.chance(0.7))
        whole.insert(std::to_string(i));
      else
        cut(split[i]);
    auto const among_whole = [&](SeamTable table) {
      std::erase_if(table, [&](auto const& entry) {
        return !whole.contains(std::get<0>(entry.first)) || !whole.contains(std::get<2>(entry.first));
      });
      return table;
    };
    Scene const pieces = scene_of(split);
    auto const rest = among_whole(expected);
    REQUIRE(among_whole(seam_table(HeightField(pieces))) == rest);
    kept += rest.size();
  }
  REQUIRE(seams > 1000);
  REQUIRE(kept > 300);
}
