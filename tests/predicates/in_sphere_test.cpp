#include "predicate_checks.hpp"
#include "support/fixtures.hpp"

/// The library has no in-circle or in-sphere predicate; their formulas (degree 4 and 5) put the layers to the test on
/// polynomials that nobody tuned them for.

using namespace visibility;
using namespace visibility::test;

namespace {

struct InCircle {
  template <class T>
  auto operator()(T const& ax, T const& ay, T const& bx, T const& by, T const& cx, T const& cy, T const& dx,
                  T const& dy) const
  {
    auto const adx = ax - dx, ady = ay - dy, bdx = bx - dx, bdy = by - dy, cdx = cx - dx, cdy = cy - dy;
    auto const a = adx * adx + ady * ady, b = bdx * bdx + bdy * bdy, c = cdx * cdx + cdy * cdy;
    return a * (bdx * cdy - cdx * bdy) + b * (cdx * ady - adx * cdy) + c * (adx * bdy - bdx * ady);
  }
};

struct InSphere {
  template <class T>
  auto operator()(T const& ax, T const& ay, T const& az, T const& bx, T const& by, T const& bz, T const& cx,
                  T const& cy, T const& cz, T const& dx, T const& dy, T const& dz, T const& ex, T const& ey,
                  T const& ez) const
  {
    auto const aex = ax - ex, aey = ay - ey, aez = az - ez, bex = bx - ex, bey = by - ey, bez = bz - ez;
    auto const cex = cx - ex, cey = cy - ey, cez = cz - ez, dex = dx - ex, dey = dy - ey, dez = dz - ez;
    auto const ab = aex * bey - bex * aey, bc = bex * cey - cex * bey, cd = cex * dey - dex * cey;
    auto const da = dex * aey - aex * dey, ac = aex * cey - cex * aey, bd = bex * dey - dex * bey;
    auto const abc = aez * bc - bez * ac + cez * ab, bcd = bez * cd - cez * bd + dez * bc;
    auto const cda = cez * da + dez * ac + aez * cd, dab = dez * ab + aez * bd + bez * da;
    auto const a = aex * aex + aey * aey + aez * aez, b = bex * bex + bey * bey + bez * bez;
    auto const c = cex * cex + cey * cey + cez * cez, d = dex * dex + dey * dey + dez * dez;
    return (d * abc - c * dab) + (b * cda - a * bcd);
  }
};

}  // namespace

TEST_CASE("layers: the in-circle determinant has its exact sign", "[predicates][agreement]")
{
  auto outcomes = check_agreement(
    InCircle{},
    [](PointSource& s) {
      auto const [a, b, c, d] = s.tuple<4>();
      return std::tuple(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y);
    },
    500);
  REQUIRE(outcomes[Recipe::grid].signs[1] > 0);
}

TEST_CASE("layers: the in-sphere determinant has its exact sign", "[predicates][agreement]")
{
  auto outcomes = check_agreement(
    InSphere{},
    [](PointSource& s) {
      auto const [a, b, c, d, e] = s.tuple<5>();
      return std::tuple(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z);
    },
    300);
  REQUIRE(outcomes[Recipe::grid].signs[1] > 0);
  REQUIRE(outcomes[Recipe::coplanar].signs[1] > 0);
}

TEST_CASE("layers: the published signs of in-circle and in-sphere are reproduced", "[predicates][oracle]")
{
  for_each_fixture<8>("incircle.txt", [](auto const& x, Sign s) {
    REQUIRE(std::apply([](auto... c) { return Filtered::sign(InCircle{}, c...); }, x) == s);
  });
  for_each_fixture<15>("insphere.txt", [](auto const& x, Sign s) {
    REQUIRE(std::apply([](auto... c) { return Filtered::sign(InSphere{}, c...); }, x) == s);
  });
}
