#include "support.hpp"

using namespace visibility;

TEST_CASE("district: about 150,000 triangles, and copies multiply them", "[generators]")
{
  auto const seed = GENERATE(1, 2, 3, 4);
  auto const scene = generate("district,seed=" + std::to_string(seed));
  REQUIRE(scene.objects.size() == 100);
  REQUIRE(std::abs(static_cast<double>(scene.triangles.size()) - 150e3) < 15e3);
  auto const small = generate("district,n=6"), copies = generate("district,n=6,copies=5");
  REQUIRE(copies.triangles.size() == 5 * small.triangles.size());
  REQUIRE(copies.objects.size() == 30);
}

TEST_CASE("district: houses are closed, face outward, and stand apart", "[generators]")
{
  auto const specification = GENERATE("district,n=16,windows=1", "district,n=16,windows=0", "district,n=5,rotation=33",
                                      "district,n=5,recess=0.8,lot=16", "district,n=3,low=1,high=1,copies=4");
  CAPTURE(specification);
  auto const scene = generate(specification);
  scene.validate();
  for (auto const& o : scene.objects) {
    CAPTURE(o.name);
    REQUIRE(test::is_closed(scene, o));
    REQUIRE(test::volume(scene, o) > 0);
    REQUIRE(bounding_box(scene, o).min.z == 0);
  }
  if (std::string(specification).find("rotation") == std::string::npos) REQUIRE(test::are_apart(scene));
}

TEST_CASE("district: windows lie behind the wall and cost 16 triangles more than a blank bay", "[generators]")
{
  // One seed, so the same houses; only the windows differ.
  auto const blank = generate("district,n=9,windows=0"), open = generate("district,n=9,windows=1");
  auto const half = generate("district,n=9,windows=0.5");
  for (std::size_t i = 0; i < 9; ++i) {
    auto const &b = blank.objects[i], &o = open.objects[i];
    REQUIRE(bounding_box(blank, b) == bounding_box(open, o));
    REQUIRE((o.triangles.size() - b.triangles.size()) % 16 == 0);
    auto const bays = (o.triangles.size() - b.triangles.size()) / 16;
    REQUIRE(bays > 20);
    auto const some = (half.objects[i].triangles.size() - b.triangles.size()) / 16;
    REQUIRE(std::abs(static_cast<double>(some) - static_cast<double>(bays) / 2) <
            5 * std::sqrt(static_cast<double>(bays)) / 2);
    // A recess of 0.2 m by 0.4 of a bay by half a storey is missing from the volume for every window.
    double const missing = test::volume(blank, b) - test::volume(open, o);
    double const each = missing / static_cast<double>(bays) / (0.2 * 0.4 * 0.5 * 3.2);
    REQUIRE((each > 3 && each < 4.5));  // the width of a bay
  }
}

TEST_CASE("district: copies are the same houses elsewhere, with streets between", "[generators]")
{
  auto const scene = generate("district,n=4,copies=3");
  auto const per_copy = scene.vertices.size() / 3;
  for (std::size_t copy = 1; copy < 3; ++copy) {
    Point3d const shift{scene.vertices[copy * per_copy].x - scene.vertices[0].x,
                        scene.vertices[copy * per_copy].y - scene.vertices[0].y, 0};
    for (std::size_t v = 0; v < per_copy; ++v) {
      auto const &p = scene.vertices[v], &q = scene.vertices[copy * per_copy + v];
      REQUIRE(std::abs(q.x - p.x - shift.x) < 1e-9);
      REQUIRE(std::abs(q.y - p.y - shift.y) < 1e-9);
      REQUIRE(q.z == p.z);
    }
  }
  REQUIRE(test::are_apart(scene));
  // The crossing in the origin is free.
  auto const one = generate("district");
  for (auto const& o : one.objects) REQUIRE_FALSE(meet(bounding_box(one, o), Box{{-1e4, -7, 0}, {1e4, 7, 1}}));
}
