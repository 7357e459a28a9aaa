#include "support/catch.hpp"

#include "generators/random.hpp"
#include "generators/rotation.hpp"
#include "generators/sites.hpp"

#include <array>
#include <cmath>
#include <set>

using namespace visibility;
using generators::Random;

TEST_CASE("random: splitmix64 as published", "[generators]")
{
  // A stream is splitmix64 from a mixed start: consecutive outputs undo to states one golden ratio apart.
  auto const unmix = [](std::uint64_t z) {
    z = (z ^ (z >> 31) ^ (z >> 62)) * 0x319642B2D24D8EC3;
    z = (z ^ (z >> 27) ^ (z >> 54)) * 0x96DE1B173F119089;
    return z ^ (z >> 30) ^ (z >> 60);
  };
  Random random(1, "test");
  auto before = unmix(random.bits());
  for (int i = 0; i < 100; ++i) {
    auto const now = unmix(random.bits());
    REQUIRE(now - before == 0x9E3779B97F4A7C15);
    before = now;
  }
}

TEST_CASE("random: streams of other seeds, purposes and objects are others", "[generators]")
{
  std::set<std::uint64_t> first;
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    for (auto const* purpose : {"a", "b", "ab", "ba"})
      for (std::uint64_t object = 0; object < 50; ++object)
        REQUIRE(first.insert(Random(seed, purpose, object).bits()).second);
}

TEST_CASE("random: numbers stay in their range and fill it evenly", "[generators]")
{
  Random random(2, "test");
  std::array<int, 7> of{};
  double sum = 0;
  for (int i = 0; i < 70'000; ++i) {
    ++of[random.below(7)];
    double const x = random.uniform(-3, 5);
    REQUIRE((x >= -3 && x <= 5));
    sum += x;
    REQUIRE(random.uniform(0.1, 0.1) == 0.1);
    int const k = random.between(4, 4);
    REQUIRE(k == 4);
  }
  for (int const n : of) REQUIRE(std::abs(n - 10'000) < 5 * 93);
  REQUIRE(std::abs(sum / 70'000 - 1) < 5 * 2.31 / std::sqrt(70'000.0));
}

TEST_CASE("direction: cosine and sine to the last places", "[generators]")
{
  for (int k = -1800; k <= 1800; ++k) {
    double const degrees = k / 10.0, angle = degrees * 3.14159265358979323846 / 180;
    auto const [c, s] = generators::direction(degrees);
    REQUIRE(std::abs(c - std::cos(angle)) < 2e-15);
    REQUIRE(std::abs(s - std::sin(angle)) < 2e-15);
  }
  REQUIRE(generators::direction(0) == Point2d{1, 0});
}

TEST_CASE("rotation: rows are orthonormal and right-handed", "[generators]")
{
  Random random(3, "test");
  auto const dot = [](Point3d const& a, Point3d const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  for (int i = 0; i < 1000; ++i) {
    auto const r = (i % 3 == 0   ? generators::any_rotation(random)
                    : i % 3 == 1 ? generators::about_x(random.around(30))
                                 : generators::about_y(random.around(30)))
                     .rows;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) REQUIRE(std::abs(dot(r[a], r[b]) - (a == b ? 1 : 0)) < 1e-14);
    Point3d const cross{r[0].y * r[1].z - r[0].z * r[1].y, r[0].z * r[1].x - r[0].x * r[1].z,
                        r[0].x * r[1].y - r[0].y * r[1].x};
    REQUIRE(std::abs(dot(cross, r[2]) - 1) < 1e-14);
  }
}

TEST_CASE("sites: rings fill squares, each site once", "[generators]")
{
  std::set<std::pair<std::int64_t, std::int64_t>> seen;
  for (std::uint64_t i = 0; i < 40'000; ++i) {
    auto const s = generators::ring_site(i);
    REQUIRE(seen.emplace(s.i, s.j).second);
    auto const ring = std::max(std::max(s.i, -1 - s.i), std::max(s.j, -1 - s.j));
    auto const index = static_cast<std::int64_t>(i);
    REQUIRE((4 * ring * ring <= index && index < 4 * (ring + 1) * (ring + 1)));
  }
}

TEST_CASE("sites: lots, streets and avenues follow each other without gap", "[generators]")
{
  generators::TownAxis const axis{20, 12, 30, 4, 2};
  for (std::int64_t i = 0; i < 100; ++i) {
    double const gap = axis(i + 1) - axis(i) - 20;
    REQUIRE(gap == ((i + 1) % 4 != 0 ? 0 : (i + 1) % 8 != 0 ? 12 : 30));
    REQUIRE(axis(-1 - i) == -axis(i));
  }
  REQUIRE(axis(0) == 25);
}
