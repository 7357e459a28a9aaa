#include "predicate_checks.hpp"
#include "visibility/predicates/line_side.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

/// The Plücker product as it is written in text books, in rationals.
Sign plucker_product(Point3d const& p, Point3d const& q, Point3d const& r, Point3d const& s)
{
  using NT = RationalNumber;
  auto const [P, Q, R, S] = std::tuple(exact(p), exact(q), exact(r), exact(s));
  auto const half = [](Point3q const& a, Point3q const& b, Point3q const& c, Point3q const& d) -> NT {
    // (b - a) . (c x d)
    return (b.x - a.x) * (c.y * d.z - c.z * d.y) + (b.y - a.y) * (c.z * d.x - c.x * d.z) +
           (b.z - a.z) * (c.x * d.y - c.y * d.x);
  };
  return static_cast<Sign>(static_cast<int>(CGAL::sign(half(P, Q, R, S) + half(R, S, P, Q))));
}

}  // namespace

TEST_CASE("line_side: it is the sign of the Plücker product", "[predicates][oracle]")
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 11);
    for (int i = 0; i < trials(500); ++i) {
      auto const [p, q, r, s] = source.tuple<4>();
      REQUIRE(line_side<Filtered>(p, q, r, s) == plucker_product(p, q, r, s));
    }
  }
}

TEST_CASE("line_side: symmetric, and reversing one line flips the sign", "[predicates][law]")
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 12);
    for (int i = 0; i < trials(200); ++i) {
      auto const [p, q, r, s] = source.tuple<4>();
      Sign const side = line_side<Filtered>(p, q, r, s);
      REQUIRE(line_side<Filtered>(r, s, p, q) == side);
      REQUIRE(line_side<Filtered>(q, p, r, s) == -side);
      REQUIRE(line_side<Filtered>(p, q, s, r) == -side);
    }
  }
}

TEST_CASE("line_side: lines that meet or are parallel are on no side", "[predicates][degenerate]")
{
  Point3d const p{0.1, 0.2, 0.3}, q{1.7, 0.9, 0.4}, r{0.3, 1.9, 0.8};
  auto const side = [](Point3d a, Point3d b, Point3d c, Point3d d) { return line_side<Filtered>(a, b, c, d); };
  CHECK(side(p, q, q, r) == Sign::zero);
  CHECK(side(p, q, r, p) == Sign::zero);
  CHECK(side({0, 0, 0}, {3, 5, 7}, {1, 1, 1}, {7, 11, 15}) == Sign::zero);    // parallel
  CHECK(side({0, 0, 0}, {3, 5, 7}, {6, 10, 14}, {9, 15, 21}) == Sign::zero);  // one line
  CHECK(side({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}) == Sign::negative);
}
