#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient3d.hpp"
#include "visibility/viewspace/divide.hpp"

#include <algorithm>

using namespace visibility;
using test::Random;

namespace {

/// Six times the volume. Exact.
RationalNumber volume(ViewCell const& cell)
{
  RationalNumber sum = 0;
  auto const& s = cell.shape();
  Point3q const o = exact(s.vertices[0]);
  for (auto const& f : s.facets) {
    Point3q p[3];
    for (std::size_t i = 0; i < 3; ++i) {
      Point3q const v = exact(s.vertices[f.vertices[i]]);
      p[i] = {v.x - o.x, v.y - o.y, v.z - o.z};
    }
    sum += p[0].x * (p[1].y * p[2].z - p[1].z * p[2].y) - p[0].y * (p[1].x * p[2].z - p[1].z * p[2].x) +
           p[0].z * (p[1].x * p[2].y - p[1].y * p[2].x);
  }
  return sum;
}

bool is_within(ViewCell const& inner, ViewCell const& outer)
{
  return std::ranges::all_of(inner.vertices(), [&](Point3d const& v) { return contains(outer, v); });
}

bool closed_contains(ViewCell const& cell, Point3q const& p)
{
  auto const& s = cell.shape();
  return std::ranges::none_of(s.facets, [&](auto const& f) {
    auto const v = [&](std::size_t i) { return exact(s.vertices[f.vertices[i]]); };
    return is_positive(orient3d<Rational>(v(0), v(1), v(2), p));
  });
}

/// A point of the cell: rational weights, so that it is in the hull exactly.
Point3q point_of(ViewCell const& cell, Random& random)
{
  Point3q sum{0, 0, 0};
  RationalNumber total = 0;
  for (auto const& v : cell.vertices()) {
    RationalNumber const w = random.below(3) * random.between(1, 1000);
    sum = {sum.x + w * RationalNumber(v.x), sum.y + w * RationalNumber(v.y), sum.z + w * RationalNumber(v.z)};
    total += w;
  }
  if (total == 0) return exact(cell.vertices()[0]);
  return {sum.x / total, sum.y / total, sum.z / total};
}

/// An oriented street: a rectangle in plan at any angle, upright.
ViewCell street(Random& random)
{
  double const x = random.uniform(-3e3, 3e3), y = random.uniform(-3e3, 3e3), angle = random.uniform(0, 6.3),
               length = random.uniform(5, 300), width = random.uniform(2, 20);
  double const c = std::cos(angle), s = std::sin(angle);
  std::vector<Point3d> points;
  for (double const z : {0.5, 2.0})
    for (auto const& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      points.push_back({x + c * u * length / 2 - s * v * width / 2, y + s * u * length / 2 + c * v * width / 2, z});
  return ViewCell::hull(points);
}

ViewCell polytope(Random& random)
{
  std::vector<Point3d> points;
  for (int i = random.between(4, 14); i > 0; --i) points.push_back(random.point(-40, 40));
  return ViewCell::hull(points);
}

}  // namespace

TEST_CASE("divide: halves are within the cell and together cover it", "[viewspace][law]")
{
  Random random(1);
  for (int trial = 0; trial < test::trials(60); ++trial) {
    auto cell = divisible(trial % 2 == 0 ? street(random) : polytope(random));
    for (int depth = 0; depth < 3; ++depth) {
      auto const parts = halves(cell);
      REQUIRE(parts);
      REQUIRE(is_within(parts->first, cell));
      REQUIRE(is_within(parts->second, cell));
      REQUIRE(volume(parts->first) + volume(parts->second) >= volume(cell));
      for (int i = 0; i < 20; ++i) {
        auto const p = point_of(cell, random);
        REQUIRE((closed_contains(parts->first, p) || closed_contains(parts->second, p)));
      }
      cell = random.below(2) == 0 ? parts->first : parts->second;
    }
  }
}

TEST_CASE("divide: an upright street is cut across, and its halves tile it", "[viewspace][law]")
{
  Random random(2);
  for (int trial = 0; trial < test::trials(40); ++trial) {
    auto cell = divisible(street(random));
    REQUIRE(cell.vertices().size() == 8);
    for (int depth = 0; depth < 8 && longest_extent(cell) > 4; ++depth) {
      double const before = longest_extent(cell);
      auto const parts = halves(cell);
      REQUIRE(parts);
      REQUIRE(parts->first.vertices().size() == 8);
      REQUIRE(parts->second.vertices().size() == 8);
      REQUIRE(volume(parts->first) + volume(parts->second) == volume(cell));
      cell = parts->second;
      REQUIRE(longest_extent(cell) <= before * (1 + 1e-9));
    }
  }
}

TEST_CASE("divide: boxes become boxes, cut across their longest side", "[viewspace]")
{
  auto const parts = halves(ViewCell(Box{{0, 0, 0}, {4, 10, 1}}));
  REQUIRE(parts);
  REQUIRE(parts->first.bounds() == Box{{0, 0, 0}, {4, 5, 1}});
  REQUIRE(parts->second.bounds() == Box{{0, 5, 0}, {4, 10, 1}});
  REQUIRE(parts->first.is_box());
  REQUIRE(longest_extent(parts->first) == 5);
}

TEST_CASE("divide: a divisible cell contains the cell and is hardly larger", "[viewspace][law]")
{
  Random random(3);
  for (int trial = 0; trial < test::trials(60); ++trial) {
    auto const cell = trial % 2 == 0 ? street(random) : polytope(random);
    auto const larger = divisible(cell);
    REQUIRE(is_within(cell, larger));
    Box const &a = cell.bounds(), &b = larger.bounds();
    REQUIRE(a.min.x - b.min.x < 1e-4);
    REQUIRE(b.max.y - a.max.y < 1e-4);
    auto const again = divisible(larger);
    REQUIRE(is_within(again, larger));
    REQUIRE(is_within(larger, again));
  }
  ViewCell const box(Box{{0.1, 0.2, 0.3}, {1, 2, 3}});
  REQUIRE(divisible(box).bounds() == box.bounds());
}

TEST_CASE("divide: what is too thin for its coordinates is not divided", "[viewspace][degenerate]")
{
  double const next = std::nextafter(1.0, 2.0);
  REQUIRE_FALSE(halves(ViewCell(Box{{1, 1, 1}, {next, next, next}})));
  Point3d const a{1, 1, 1}, b{next, 1, 1}, c{1, next, 1}, d{1, 1, next};
  REQUIRE_FALSE(halves(ViewCell::hull(std::vector{a, b, c, d})));
  // Edges of odd length in units of the last place have no middle; those of a divisible cell have.
  auto const thin =
    ViewCell::hull(std::vector<Point3d>{{0.1, 0.1, 0.1}, {7.3, 0.3, 0.2}, {0.7, 5.9, 0.3}, {1.1, 1.3, 3.7}});
  REQUIRE(halves(divisible(thin)));
}
