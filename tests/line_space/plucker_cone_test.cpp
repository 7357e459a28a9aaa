#include "brute_force_cone.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;

namespace {

/// What of a cone does not depend on the order of insertion: the dimension of its lineality space and its rays by what
/// they touch, here as positions in `half_spaces`.
template <class NT>
ConeSummary summary(std::vector<SmallVector> const& half_spaces, std::vector<std::size_t> const& order)
{
  PluckerCone<NT> cone;
  for (auto const i : order) {
    cone.insert(as_line<NT>(half_spaces[i]));
    cone.validate();
  }
  ConeSummary s{cone.lineality().size(), {}};
  for (auto const& r : cone.rays()) {
    std::vector<bool> tight(half_spaces.size());
    for (std::size_t k = 0; k < order.size(); ++k) tight[order[k]] = r.tight.contains(k);
    s.rays.insert(tight);
  }
  REQUIRE(s.rays.size() == cone.rays().size());  // no ray twice
  return s;
}

std::vector<std::size_t> identity(std::size_t n)
{
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  return order;
}

void shuffle(std::vector<std::size_t>& order, Random& random)
{
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
}

}  // namespace

TEMPLATE_TEST_CASE("PluckerCone: its rays are those that brute force finds, in any order of insertion",
                   "[line_space][oracle]", ExactNumber, CGAL::Gmpz, RationalNumber)
{
  Random random(71);
  int with_lines = 0, flat = 0, pointed = 0;
  for (int i = 0; i < trials(150); ++i) {
    auto const half_spaces = small_half_spaces(random);
    CAPTURE(i);
    auto const expected = brute_force(half_spaces);
    auto order = identity(half_spaces.size());
    for (int repeat = 0; repeat < 2; ++repeat) {
      REQUIRE(summary<TestType>(half_spaces, order) == expected);
      shuffle(order, random);
    }
    PluckerCone<TestType> cone;
    for (auto const& h : half_spaces) cone.insert(as_line<TestType>(h));
    REQUIRE(cone.has_interior() == has_interior(expected));
    if (cone.has_interior())
      for (auto const& h : half_spaces)
        REQUIRE(is_positive(number_sign(plucker_product(cone.interior(), as_line<TestType>(h)))));
    ++(expected.lineality > 0 ? with_lines : has_interior(expected) ? pointed : flat);
  }
  CHECK(with_lines > 10);
  CHECK(flat > 5);
  CHECK(pointed > 10);
}

TEST_CASE("PluckerCone: repeated half-spaces are harmless", "[line_space][degenerate]")
{
  Random random(72);
  for (int i = 0; i < trials(100); ++i) {
    auto const half_spaces = small_half_spaces(random);
    PluckerCone<ExactNumber> once, twice;
    for (auto const& h : half_spaces) {
      once.insert(as_line<ExactNumber>(h));
      for (int j = 0; j < 2; ++j) twice.insert(as_line<ExactNumber>(h));
    }
    REQUIRE(once.rays().size() == twice.rays().size());
    REQUIRE(once.lineality().size() == twice.lineality().size());
    for (std::size_t r = 0; r < once.rays().size(); ++r) REQUIRE(once.rays()[r].line == twice.rays()[r].line);
  }
}

TEST_CASE("PluckerCone: opposite half-spaces leave a cone in a hyperplane", "[line_space][degenerate]")
{
  Random random(73);
  for (int i = 0; i < trials(100); ++i) {
    auto half_spaces = small_half_spaces(random);
    half_spaces.push_back(half_spaces.front());
    for (int& x : half_spaces.back()) x = -x;
    REQUIRE(summary<ExactNumber>(half_spaces, identity(half_spaces.size())) == brute_force(half_spaces));
    PluckerCone<ExactNumber> cone;
    for (auto const& h : half_spaces) cone.insert(as_line<ExactNumber>(h));
    REQUIRE(!cone.has_interior());
  }
}

TEST_CASE("PluckerCone: no half-space, a zero half-space, and the cone {0}", "[line_space][degenerate]")
{
  PluckerCone<ExactNumber> cone;
  CHECK(cone.has_interior());
  CHECK(cone.lineality().size() == 6);
  cone.insert({});
  CHECK(!cone.has_interior());
  CHECK(cone.lineality().size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    PluckerLine<ExactNumber> h;
    h[i] = 1;
    cone.insert(h);
    cone.insert(reversed(h));
    cone.validate();
  }
  CHECK(cone.lineality().empty());
  CHECK(cone.rays().empty());
  CHECK(!cone.has_interior());
}

TEST_CASE("PluckerCone: more than 64 half-spaces", "[line_space][law]")
{
  Random random(74);
  PluckerCone<ExactNumber> cone;
  auto const h = [&] {
    PluckerLine<ExactNumber> l;
    for (std::size_t i = 0; i < 5; ++i) l[i] = random.between(-50, 50);
    l[5] = 100;
    return l;
  };
  for (int i = 0; i < 150; ++i) cone.insert(h());
  cone.validate();
  CHECK(cone.has_interior());
  // Every ray of a pointed cone touches half-spaces of rank 5, at least 5.
  for (auto const& r : cone.rays()) REQUIRE(r.tight.size() >= 5);
}
