#include "support.hpp"

using namespace visibility;

namespace {

double distance(Point3d const& a, Point3d const& b)
{
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

}  // namespace

TEST_CASE("box field: boxes are exactly convex solids of the sizes promised", "[generators]")
{
  auto const scene = generate("box-field,n=1000");
  REQUIRE(scene.triangles.size() == 12'000);
  scene.validate();
  REQUIRE(test::convex_solids(scene) == 1000);
  double sum = 0;
  for (std::size_t i = 0; i < 1000; ++i) {
    REQUIRE(test::is_closed(scene, scene.objects[i]));
    REQUIRE(test::volume(scene, scene.objects[i]) > 0);
    auto const* corner = &scene.vertices[8 * i];
    for (int axis : {1, 2, 4})
      for (int c = 0; c < 8; ++c) {
        if ((c & axis) != 0) continue;
        double const side = distance(corner[c], corner[c | axis]);
        REQUIRE((side >= 1 - 1e-12 && side <= 10 + 1e-12));
        sum += side;
      }
  }
  REQUIRE(std::abs(sum / 12'000 - 5.5) < 5 * 2.6 / std::sqrt(3000.0));
}

TEST_CASE("box field: any orientation is as likely as another", "[generators]")
{
  auto const scene = generate("box-field,n=4000");
  // The first side of a box is a uniform direction u: the mean of u u^T is a third of the identity.
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
  for (std::size_t i = 0; i < 4000; ++i) {
    auto const &a = scene.vertices[8 * i], &b = scene.vertices[8 * i + 1];
    double const d = distance(a, b), x = (b.x - a.x) / d, y = (b.y - a.y) / d, z = (b.z - a.z) / d;
    xx += x * x, yy += y * y, zz += z * z, xy += x * y, yz += y * z, zx += z * x;
  }
  for (double const s : {xx, yy, zz}) REQUIRE(std::abs(s / 4000 - 1.0 / 3) < 0.025);  // 5 sigma
  for (double const s : {xy, yz, zx}) REQUIRE(std::abs(s / 4000) < 0.021);
}

TEST_CASE("box field: the cleared column and the ground are free", "[generators]")
{
  auto const specification =
    GENERATE("box-field,n=2000", "box-field,n=3,density=10,clear=1000", "box-field,n=500,clear=0");
  CAPTURE(specification);
  auto const scene = generate(specification);
  double const clear = std::string(specification).find("1000") != std::string::npos      ? 1000
                       : std::string(specification).find("clear=0") != std::string::npos ? 0
                                                                                         : 20;
  for (auto const& o : scene.objects) {
    auto const b = bounding_box(scene, o);
    REQUIRE_FALSE(meet(b, Box{{-clear, -clear, 0}, {clear, clear, 100}}));
    REQUIRE((b.min.z >= 0 && b.max.z <= 50));
  }
}
