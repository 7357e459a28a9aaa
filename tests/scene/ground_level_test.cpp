#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/scene/ground_level.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

double level_of(std::vector<double> const& feet)
{
  std::vector<Box> bounds;
  for (double const z : feet) bounds.push_back({{0, 0, z}, {1, 1, z + 1}});
  return ground_level(bounds);
}

}  // namespace

TEST_CASE("ground level: the lowest foot, but for a few strays below a level of many", "[scene]")
{
  CHECK(level_of({}) == 0);
  CHECK(level_of({7}) == 7);
  CHECK(level_of({3, 1, 2}) == 1);
  std::vector<double> feet(400, 0.0);
  CHECK(level_of(feet) == 0);
  feet[10] = -1e-6;
  feet[20] = -50;
  CHECK(level_of(feet) == 0);
  feet[30] = -1;  // one more than one in 200
  CHECK(level_of(feet) == -50);
}

TEST_CASE("ground level: few reach below, and half stand no higher unless it is the lowest", "[scene][law]")
{
  for (int seed = 1; seed <= trials(300); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<double> feet(std::size_t(random.between(1, 900)));
    int const heights = random.between(1, 4), strays = random.between(0, 6);
    for (auto& z : feet) z = random.between(0, heights);
    for (int i = 0; i < strays; ++i) feet[std::size_t(random.below(int(feet.size())))] = -random.uniform(0, 9);
    double const level = level_of(feet);
    auto const count = [&](auto const& is) { return std::size_t(std::ranges::count_if(feet, is)); };
    REQUIRE(count([&](double z) { return z < level; }) * 200 <= feet.size());
    REQUIRE((level == std::ranges::min(feet) || 2 * count([&](double z) { return z <= level; }) > feet.size()));
    std::ranges::shuffle(feet, std::mt19937_64(random.bits()));
    REQUIRE(level_of(feet) == level);
  }
}
