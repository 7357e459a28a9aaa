#include "support/catch.hpp"
#include "visibility/evidence/compare.hpp"

using visibility::compare;
using Names = std::vector<std::string>;

TEST_CASE("compare: sizes, both differences and ratios, doubles counted once", "[evidence]")
{
  Names const a{"tower", "hall", "mill", "mill"}, b{"hall", "barn"};
  auto const c = compare(a, b);
  CHECK(c.size_a == 3);
  CHECK(c.size_b == 2);
  CHECK(c.common == 1);
  CHECK(c.only_a == Names{"mill", "tower"});
  CHECK(c.only_b == Names{"barn"});
  CHECK(c.overestimation() == 1.5);
  CHECK(c.recall() == 0.5);
  CHECK_FALSE(c.equal());
}

TEST_CASE("compare: a set equals itself in any order; empty sets have defined ratios", "[evidence][degenerate]")
{
  Names const a{"x", "y"}, r{"y", "x"}, none;
  CHECK(compare(a, r).equal());
  CHECK(compare(none, none).overestimation() == 1);
  CHECK(compare(none, none).recall() == 1);
  CHECK(std::isinf(compare(a, none).overestimation()));
}
