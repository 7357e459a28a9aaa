#include "copositive.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trials.hpp"
#include "visibility/line_space/stabbing_line.hpp"
#include "visibility/predicates/line_side.hpp"

#include <cmath>

using namespace visibility;
using namespace visibility::test;

namespace {

using Line = PluckerLine<ExactNumber>;
using Points = std::array<Point3d, 2>;

Line line(Points const& s)
{
  auto const as = [](Point3d const& p) { return Point3<ExactNumber>{p.x, p.y, p.z}; };
  return line_through(as(s[0]), as(s[1]));
}

std::vector<Line> lines(std::vector<Points> const& list)
{
  std::vector<Line> result;
  for (auto const& s : list) result.push_back(line(s));
  return result;
}

bool exists(std::vector<Line> const& h) { return has_strict_stabbing_line(std::span<Line const>(h)); }

/// Finds a line and checks it by the points that name the half-spaces.
bool found_and_strict(std::vector<Points> const& list)
{
  auto const h = lines(list);
  auto const l = strict_stabbing_line(std::span<Line const>(h));
  REQUIRE(l.has_value() == exists(h));
  if (!l) return false;
  auto const [p, q] = two_points(rational(*l));
  for (auto const& s : list) REQUIRE(is_positive(line_side<Rational>(p, q, exact(s[0]), exact(s[1]))));
  return true;
}

Points turned_to(Points s, Points const& l)
{
  if (is_negative(line_side<Filtered>(l[0], l[1], s[0], s[1]))) std::swap(s[0], s[1]);
  return s;
}

/// The line of a ruling of (x^2 + y^2) / r^2 = 1 + z^2 at an angle; `slope` +1 or -1 chooses the ruling.
Points ruling(double r, double angle, double slope)
{
  double const c = r * std::cos(angle), s = r * std::sin(angle);
  return {Point3d{c + slope * s, s - slope * c, -1}, Point3d{c - slope * s, s + slope * c, 1}};
}

}  // namespace

TEST_CASE("strict_stabbing_line: few half-spaces always have one, at infinity or not", "[line_space][degenerate]")
{
  CHECK(found_and_strict({}));
  CHECK(found_and_strict({{Point3d{0, 0, 0}, Point3d{1, 2, 3}}}));
  CHECK(found_and_strict({{Point3d{0, 0, 0}, Point3d{0, 0, 1}}, {Point3d{1, 0, 0}, Point3d{1, 0, 1}}}));
  CHECK(found_and_strict({{Point3d{0, 0, 0}, Point3d{0, 0, 1}}, {Point3d{1, 0, 1}, Point3d{1, 0, 0}}}));
  CHECK(!found_and_strict({{Point3d{0, 0, 0}, Point3d{0, 0, 1}}, {Point3d{0, 0, 1}, Point3d{0, 0, 0}}}));
  CHECK(!found_and_strict({{Point3d{1, 2, 3}, Point3d{1, 2, 3}}}));
}

TEST_CASE("strict_stabbing_line: through a convex polygon, and two that face each other", "[line_space][degenerate]")
{
  auto const polygon = [](double z, double size, std::vector<Points>& list) {
    Point3d const v[4] = {{size, size, z}, {-size, size, z}, {-size, -size, z}, {size, -size, z}};
    for (std::size_t i = 0; i < 4; ++i) list.push_back({v[i], v[(i + 1) % 4]});
  };
  std::vector<Points> list;
  for (int i = 0; i < 5; ++i) {
    polygon(i, 1 + i % 2, list);
    CHECK(found_and_strict(list));
  }
  polygon(5, -1, list);  // a half turn: the same polygon
  CHECK(found_and_strict(list));
  list.push_back({Point3d{-5, 1, 2}, Point3d{5, 1, 2}});  // in the plane y = 1: only grazing lines are left
  CHECK(!found_and_strict(list));
  list.back() = {Point3d{-5, 1 - 0x1p-53, 2}, Point3d{5, 1 - 0x1p-53, 2}};
  CHECK(found_and_strict(list));
}

TEST_CASE("strict_stabbing_line: all lines on the sides of a known line", "[line_space][law]")
{
  Random random(91);
  for (int i = 0; i < trials(300); ++i) {
    CAPTURE(i);
    bool const grid = random.chance(0.5);
    auto const any = [&] { return grid ? random.grid_point(-3, 3) : random.point(-3, 3); };
    Points const known{any(), any()};
    std::vector<Points> list;
    for (int n = random.between(1, 14); n > 0; --n) {
      Points const s = turned_to({any(), any()}, known);
      if (!is_zero(line_side<Filtered>(known[0], known[1], s[0], s[1]))) list.push_back(s);
    }
    REQUIRE(found_and_strict(list));
  }
}

TEST_CASE("strict_stabbing_line: random sides; denials are certified by subdivision", "[line_space][oracle]")
{
  Random random(92);
  int yes = 0, no = 0, certified = 0;
  for (int i = 0; i < trials(300); ++i) {
    CAPTURE(i);
    bool const grid = random.chance(0.5);
    std::vector<Points> list;
    // Around one line, so that the cones have interior more often than not; then a few at random.
    Points const axis{Point3d{0, 0, -3}, Point3d{0.1, 0, 3}};
    for (int n = random.between(5, 9); n > 0; --n) {
      Points const s{grid ? random.grid_point(-2, 2) : random.point(-2, 2),
                     grid ? random.grid_point(-2, 2) : random.point(-2, 2)};
      list.push_back(random.chance(0.55) ? turned_to(s, axis) : s);
    }
    if (found_and_strict(list)) {
      ++yes;
      continue;
    }
    ++no;
    auto const h = lines(list);
    PluckerCone<ExactNumber> const cone{std::span<Line const>(h)};
    cone.validate();
    std::vector<PluckerLine<RationalNumber>> rays;
    for (auto const& r : cone.rays()) rays.push_back(rational(r.line));
    certified += !cone.has_interior() || never_positive(rays, 1) || never_positive(rays, -1);
  }
  CAPTURE(yes, no, certified);
  CHECK(yes > 50);
  CHECK(no > 20);
  CHECK(certified * 10 >= no * 9);
}

TEST_CASE("QuadricSearch: a regulus inside of a 2-face, where pairs of rays see nothing", "[line_space][degenerate]")
{
  // Three rulings of a hyperboloid touch all lines of the opposite ruling. Three lines inside of it bound a triangle of
  // the face around that regulus; the first three again, moved inwards and turned, keep the cone thin.
  Points const inner = ruling(1, 0.3, -1);
  std::vector<Points> list;
  for (double const angle : {0.0, 2.0, 4.0}) {
    Points const h = ruling(1, angle, 1), k = ruling(1 - 1e-6, angle, 1), turned = turned_to(k, inner);
    list.push_back(turned[0] == k[0] ? Points{h[1], h[0]} : h);  // against k: a slab between the two
    list.push_back(turned);
  }
  for (double const angle : {0.1, 2.2, 4.3}) list.push_back(turned_to(ruling(0.9, angle, -1), inner));
  auto const h = lines(list);
  PluckerCone<ExactNumber> const cone{std::span<Line const>(h)};
  REQUIRE(cone.has_interior());
  QuadricSearch<ExactNumber> const search(cone);
  int faces = 0;
  for (Sign const s : {Sign::positive, Sign::negative})
    if (auto const found = search.find(s)) {
      REQUIRE(number_sign(plucker_form(found->line)) == s);
      faces += found->stage == QuadricSearch<ExactNumber>::Stage::faces;
    }
  CHECK(faces == 1);
  CHECK(!has_strict_stabbing_line(std::span<Line const>(h), SearchDepth::edges));
  CHECK(found_and_strict(list));
}
