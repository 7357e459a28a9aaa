#include "support.hpp"

using namespace visibility;

TEST_CASE("city: the counts of the paper by default, and of the paper's words", "[generators]")
{
  auto const scene = generate("city");
  REQUIRE(scene.objects.size() == 2496);
  REQUIRE(scene.boxes.size() == 3324);
  REQUIRE(generate("city,triples=0.25").boxes.size() == 3744);
  REQUIRE(generate("city,triples=0").boxes.size() == 2496);
  REQUIRE(generate("city,triples=1").boxes.size() == 3 * 2496);
  REQUIRE(generate("city,n=5").objects.size() == 1);
}

TEST_CASE("city: the view space of 400 x 400 is free, and nothing larger than promised", "[generators]")
{
  auto const scene = generate("city");
  std::size_t near = 0;
  for (auto const& b : scene.boxes) {
    REQUIRE_FALSE(meet(b, Box{{-200, -200, 0}, {200, 200, 900}}));
    near += meet(b, Box{{-250, -250, 0}, {250, 250, 1}}) ? 1 : 0;
  }
  REQUIRE(near == 12);  // the buildings around four removed ones touch the free square of side 500
}

TEST_CASE("city: bases are squares of 100, heights uniform in [200, 900]", "[generators]")
{
  auto const scene = generate("city");
  double sum = 0, least = 1e9, greatest = 0;
  for (auto const& o : scene.objects) {
    auto const all = bounding_box(scene, o);
    REQUIRE(all.max.x - all.min.x == 100);
    REQUIRE(all.max.y - all.min.y == 100);
    REQUIRE(all.min.z == 0);
    REQUIRE((o.boxes.size() == 1 || o.boxes.size() == 3));
    REQUIRE(scene.boxes[o.boxes.first].max.x == all.max.x);  // the base is the first box
    sum += all.max.z;
    least = std::min(least, all.max.z);
    greatest = std::max(greatest, all.max.z);
  }
  REQUIRE(least >= 200);
  REQUIRE(greatest <= 900);
  REQUIRE(least < 210);
  REQUIRE(greatest > 890);
  // Standard deviation of the mean: 700 / sqrt(12 * 2496) = 4.04.
  REQUIRE(std::abs(sum / 2496 - 550) < 5 * 4.04);
}

TEST_CASE("city: boxes have disjoint interiors, and those of a tower stand on each other", "[generators]")
{
  auto const scene = generate("city,n=196,triples=0.5,street=10");
  auto const overlap = [](Box const& a, Box const& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y && a.min.z < b.max.z &&
           b.min.z < a.max.z;
  };
  for (std::size_t i = 0; i < scene.boxes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) REQUIRE_FALSE(overlap(scene.boxes[i], scene.boxes[k]));
  for (auto const& o : scene.objects)
    for (auto i = o.boxes.first + 1; i < o.boxes.last; ++i) {
      auto const &upper = scene.boxes[i], &lower = scene.boxes[i - 1];
      REQUIRE(upper.min.z == lower.max.z);
      REQUIRE(upper.has_interior());
      REQUIRE((lower.min.x <= upper.min.x && upper.max.x <= lower.max.x));
      REQUIRE((lower.min.y <= upper.min.y && upper.max.y <= lower.max.y));
    }
}
