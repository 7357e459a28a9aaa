#include "predicate_checks.hpp"
#include "visibility/predicates/direction_side.hpp"
#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"

using namespace visibility;
using namespace visibility::test;

TEST_CASE("direction_side: every layer agrees with rationals, in space and in the plane", "[predicates][layer]")
{
  auto const in_space = check_agreement(
    detail::DirectionSide3dFormula{},
    [](PointSource& source) {
      auto const [a, b, p, q, r] = source.tuple<5>();
      return std::tuple(a.x, a.y, a.z, b.x, b.y, b.z, p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y, r.z);
    },
    500);
  auto const in_plane = check_agreement(
    detail::DirectionSide2dFormula{},
    [](PointSource& source) {
      auto const [a, b, p, q] = source.tuple<4>();
      return std::tuple(a.x, a.y, b.x, b.y, p.x, p.y, q.x, q.y);
    },
    500);
  for (auto const* outcomes : {&in_space, &in_plane}) {
    CHECK(outcomes->at(Recipe::uniform).layers.exact == 0);
    CHECK(outcomes->at(Recipe::grid).signs[1] > 0);
    CHECK(outcomes->at(Recipe::collinear).signs[1] > 0);
  }
  CHECK(in_space.at(Recipe::nextafter).layers.exact > 0);
}

TEST_CASE("direction_side: antisymmetric, and an orientation where the direction starts on the line or plane",
          "[predicates][law]")
{
  for (Recipe const recipe : all_recipes) {
    CAPTURE(name(recipe));
    PointSource source(recipe, 21);
    for (int i = 0; i < trials(200); ++i) {
      auto const [a, b, p, q, r] = source.tuple<5>();
      Sign const s = direction_side<Filtered>(a, b, p, q, r);
      REQUIRE(direction_side<Filtered>(b, a, p, q, r) == -s);
      REQUIRE(direction_side<Filtered>(a, b, q, p, r) == -s);
      REQUIRE(direction_side<Filtered>(a, b, q, r, p) == s);
      REQUIRE(direction_side<Filtered>(p, b, p, q, r) == orient3d<Filtered>(p, q, r, b));
      auto const A = horizontal(a), B = horizontal(b), P = horizontal(p), Q = horizontal(q);
      Sign const t = direction_side<Filtered>(A, B, P, Q);
      REQUIRE(direction_side<Filtered>(B, A, P, Q) == -t);
      REQUIRE(direction_side<Filtered>(A, B, Q, P) == -t);
      REQUIRE(direction_side<Filtered>(P, B, P, Q) == orient2d<Filtered>(P, Q, B));
    }
  }
}

TEST_CASE("direction_side: parallel is zero", "[predicates][degenerate]")
{
  auto const side = [](Point3d const& a, Point3d const& b) {
    return direction_side<Filtered>(a, b, Point3d{0, 0, 0}, Point3d{1, 0, 0}, Point3d{0, 1, 0});
  };
  CHECK(side({5, 5, 5}, {6, 7, 5}) == Sign::zero);
  CHECK(side({5, 5, 5}, {6, 7, 6}) == Sign::positive);
  CHECK(side({5, 5, -5}, {6, 7, -6}) == Sign::negative);
  CHECK(direction_side<Filtered>(Point2d{3, 3}, Point2d{5, 7}, Point2d{0, 0}, Point2d{1, 2}) == Sign::zero);
  CHECK(direction_side<Filtered>(Point2d{3, 3}, Point2d{3, 4}, Point2d{0, 0}, Point2d{1, 0}) == Sign::positive);
}
