#include "meshes.hpp"

#include "support/catch.hpp"
#include "support/trials.hpp"

#include "visibility/scene/generators.hpp"
#include "visibility/scene/grounded.hpp"
#include "visibility/scene/height_field.hpp"

#include <array>
#include <bitset>

using namespace visibility;
using namespace visibility::test;

namespace {

bool has_room_below(Triangles const& mesh)
{
  Scene const scene = scene_of(mesh);
  return HeightField(scene).raised() > 0;
}

Triangles block(double x0, double y0, double z0, double x1, double y1, double z1)
{
  return extrusion({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, z0, z1);
}

Triangle triangle(Point3d const& a, Point3d const& b, Point3d const& c) { return {{a, b, c}}; }

Triangles joined(std::initializer_list<Triangles> parts)
{
  Triangles mesh;
  for (auto const& p : parts) append(mesh, p);
  return mesh;
}

/// Unit cubes in [0, n)^2 x [0, n), and whether air outside them gets below one of them. Between two cubes of air
/// nothing stands: walls are faces of solid cubes.
class Cubes {
public:
  static constexpr int n = 6;

  void fill(std::array<int, 3> const& low, std::array<int, 3> const& high)
  {
    for (int x = low[0]; x < high[0]; ++x)
      for (int y = low[1]; y < high[1]; ++y)
        for (int z = low[2]; z < high[2]; ++z) solid_.set(at(x, y, z));
  }

  bool has_room_below() const
  {
    std::bitset<count> air;
    std::vector<std::array<int, 3>> todo;
    auto const enter = [&](int x, int y, int z) {
      if (x < 0 || y < 0 || z < 0 || x >= n || y >= n || z >= n || solid_[at(x, y, z)] || air[at(x, y, z)]) return;
      air.set(at(x, y, z));
      todo.push_back({x, y, z});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (auto const& p : {std::array{0, i, j}, {n - 1, i, j}, {i, 0, j}, {i, n - 1, j}, {i, j, n - 1}})
          enter(p[0], p[1], p[2]);
    while (!todo.empty()) {
      auto const [x, y, z] = todo.back();
      todo.pop_back();
      enter(x - 1, y, z), enter(x + 1, y, z), enter(x, y - 1, z), enter(x, y + 1, z), enter(x, y, z - 1),
        enter(x, y, z + 1);
    }
    for (int x = 0; x < n; ++x)
      for (int y = 0; y < n; ++y) {
        bool covered = false;
        for (int z = n - 1; z >= 0; --z) {
          covered |= solid_[at(x, y, z)];
          if (covered && air[at(x, y, z)]) return true;
        }
      }
    return false;
  }

private:
  static constexpr std::size_t count = n * n * n;
  static std::size_t at(int x, int y, int z) { return static_cast<std::size_t>((x * n + y) * n + z); }
  std::bitset<count> solid_;
};

}  // namespace

TEST_CASE("walls: a closed mesh on the ground has all of its own", "[scene]")
{
  for (int kind = 0; kind < plan_kinds; ++kind) CHECK(!has_room_below(extrusion(plan_of(kind), 0, 7)));
  Random random(1);
  CHECK(!has_room_below(dented_box(random, 3)));
}

TEST_CASE("walls: a deck on pillars has room below", "[scene][regression]")
{
  auto const pillars = joined({block(0, 0, 0, 1, 1, 4), block(7, 7, 0, 8, 8, 4)});
  CHECK(has_room_below(joined({pillars, block(0, 0, 4, 8, 8, 5)})));
  CHECK(!has_room_below(joined({pillars, block(0, 0, 0, 8, 8, 5)})));
}

TEST_CASE("walls: a tower stands on the roof of its podium, a ledge on nothing", "[scene]")
{
  auto const podium = block(0, 0, 0, 10, 10, 4);
  CHECK(!has_room_below(joined({podium, block(2, 3, 4, 7, 8, 20)})));
  CHECK(!has_room_below(joined({podium, block(2, 3, 3, 10, 8, 20)})));  // one wall above the other, not of one size
  CHECK(has_room_below(joined({podium, block(2, 3, 4.001, 7, 8, 20)})));
  CHECK(has_room_below(joined({podium, block(2, 3, 4, 11, 8, 20)})));
  CHECK(has_room_below(joined({podium, block(10, 3, 3, 10.5, 8, 4)})));
}

TEST_CASE("walls: a wall that is missing, short or leaning outwards", "[scene]")
{
  auto const whole = block(0, 0, 0, 8, 8, 5);
  for (std::size_t i = 0; i < 8; ++i) {  // the walls come first
    auto mesh = whole;
    mesh.erase(mesh.begin() + static_cast<std::ptrdiff_t>(i));
    CAPTURE(i);
    CHECK(has_room_below(mesh));
  }
  Triangles const roof(whole.begin() + 8, whole.begin() + 10);
  CHECK(has_room_below(joined({roof, block(20, 0, 0, 21, 1, 1)})));
  for (double const top : {0.1, -0.1}) {  // the roof wider than the floor, or narrower
    auto mesh = whole;
    for (auto& t : mesh)
      for (auto& p : t.vertices)
        if (p.z == 5 && p.x == 8) p.x += top;
    CHECK(has_room_below(mesh) == (top > 0));
  }
}

TEST_CASE("walls: in pieces that fit no edge", "[scene]")
{
  Triangles mesh(block(0, 0, 0, 8, 8, 4));
  mesh.erase(mesh.begin(), mesh.begin() + 2);  // of the wall along y = 0
  Triangles const pieces{triangle({0, 0, 0}, {5, 0, 0}, {3, 0, 4}), triangle({0, 0, 0}, {3, 0, 4}, {0, 0, 4}),
                         triangle({5, 0, 0}, {8, 0, 0}, {8, 0, 4}), triangle({3, 0, 4}, {5, 0, 0}, {8, 0, 4})};
  CHECK(!has_room_below(joined({mesh, pieces})));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    auto fewer = pieces;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    CAPTURE(i);
    CHECK(has_room_below(joined({mesh, fewer})));
  }
}

TEST_CASE("walls: curtains alone go down to the ground or do not", "[scene]")
{
  Triangles const ground{triangle({20, 20, 0}, {21, 20, 0}, {20, 21, 0})};
  Triangles const fence{triangle({0, 0, 0}, {8, 4, 0}, {8, 4, 3}), triangle({0, 0, 0}, {8, 4, 3}, {0, 0, 3})};
  CHECK(!has_room_below(joined({ground, fence})));
  CHECK(has_room_below(joined({ground, {fence[1]}})));
  CHECK(!has_room_below(joined({ground, {fence[0]}})));
}

TEST_CASE("walls: as blocks of cubes have them", "[scene][oracle]")
{
  int hanging = 0, standing = 0;
  for (int seed = 1; seed <= trials(400); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    Cubes cubes;
    Triangles mesh;
    for (int k = random.between(1, 5); k >= 0; --k) {
      std::array<int, 3> low, high;
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = random.between(0, Cubes::n - 1);
        high[i] = random.between(low[i] + 1, Cubes::n);
      }
      if (random.chance(0.6)) low[2] = 0;
      if (k == 0) low = {0, 0, 0}, high = {1, 1, 1};  // on the ground
      cubes.fill(low, high);
      append(mesh, block(low[0], low[1], low[2], high[0], high[1], high[2]));
    }
    for (auto& t : mesh)
      for (auto& p : t.vertices) p = {3 * p.x - 4 * p.y, 4 * p.x + 3 * p.y, p.z};
    shuffle(mesh, random);
    bool const truth = cubes.has_room_below();
    REQUIRE(has_room_below(mesh) == truth);
    REQUIRE(HeightField(grounded(scene_of(mesh))).raised() == 0);
    ++(truth ? hanging : standing);
  }
  REQUIRE(hanging > 30);
  REQUIRE(standing > 30);
}

TEST_CASE("walls: generated cities, and the decks and ledges of one", "[scene][regression]")
{
  auto const raised = [](std::string const& source) {
    Scene const scene = generate(source);
    return HeightField(scene).raised();
  };
  CHECK(raised("urban,n=100,decks=0,ledge=0") == 0);
  CHECK(raised("urban,n=100") > 0);
  CHECK(raised("urban,n=100,decks=0") > 0);
}
