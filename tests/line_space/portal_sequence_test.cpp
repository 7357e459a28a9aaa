#include "copositive.hpp"
#include "portal_oracle.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"
#include "visibility/line_space/portal_half_spaces.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;

namespace {

/// Whether q or -q is certified never to be positive on the cone, or the cone has no interior.
bool certified_empty(PortalSequence const& s)
{
  auto const lines = portal_half_spaces<RationalNumber>(s, integer_frame(s));
  PluckerCone<RationalNumber> const cone{std::span<PluckerLine<RationalNumber> const>(lines)};
  cone.validate();
  if (!cone.has_interior()) return true;
  if (!cone.lineality().empty()) return false;
  std::vector<PluckerLine<RationalNumber>> rays;
  for (auto const& r : cone.rays()) rays.push_back(r.line);
  return never_positive(rays, 1) || never_positive(rays, -1);
}

}  // namespace

TEST_CASE("find_sight_line: what it finds is a sight line, and it finds one iff has_sight_line", "[line_space][law]")
{
  for (PortalFamily const family : all_portal_families) {
    CAPTURE(name(family));
    PortalSource source(family, 81);
    int yes = 0, no = 0;
    for (int i = 0; i < trials(400); ++i) {
      CAPTURE(i);
      auto const s = source.sequence(source.random().between(0, 5));
      auto const line = find_sight_line(s);
      REQUIRE(line.has_value() == has_sight_line(s));
      ++(line ? yes : no);
      if (line) REQUIRE(is_sight_line(s, (*line)[0], (*line)[1]));
    }
    CHECK(yes > 40);
    CHECK(no > 40);
  }
}

TEST_CASE("has_sight_line: the same in every exact arithmetic and every frame", "[line_space][law]")
{
  for (PortalFamily const family : all_portal_families) {
    CAPTURE(name(family));
    PortalSource source(family, 82);
    for (int i = 0; i < trials(60); ++i) {
      auto const s = source.sequence(source.random().between(0, 4));
      bool const expected = has_sight_line<ExactNumber>(s);
      REQUIRE(has_sight_line<RationalNumber>(s) == expected);
      REQUIRE(has_sight_line<CGAL::Gmpz>(s) == expected);
      auto const unscaled = portal_half_spaces<ExactNumber>(s);
      REQUIRE(has_strict_stabbing_line(std::span<PluckerLine<ExactNumber> const>(unscaled)) == expected);
    }
  }
}

TEST_CASE("has_sight_line: no order, duplicate or implied point changes it", "[line_space][law]")
{
  for (PortalFamily const family : all_portal_families) {
    CAPTURE(name(family));
    PortalSource source(family, 83);
    Random& random = source.random();
    for (int i = 0; i < trials(100); ++i) {
      auto s = source.sequence(random.between(1, 4));
      bool const expected = has_sight_line(s);
      auto lines = portal_half_spaces<ExactNumber>(s, integer_frame(s));
      for (std::size_t k = lines.size(); k > 1; --k)
        std::swap(lines[k - 1], lines[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
      REQUIRE(has_strict_stabbing_line(std::span<PluckerLine<ExactNumber> const>(lines)) == expected);
      s.occluders.push_back(s.occluders.front());
      add_end_points(s);
      std::reverse(s.occluders.begin(), s.occluders.end());
      std::reverse(s.points.begin(), s.points.end());
      REQUIRE(has_sight_line(s) == expected);
    }
  }
}

TEST_CASE("has_sight_line: seen from the other end, and mirrored, the answer is the same", "[line_space][law]")
{
  using Edge = PortalSequence::Edge;
  for (PortalFamily const family : all_portal_families) {
    CAPTURE(name(family));
    PortalSource source(family, 84);
    for (int i = 0; i < trials(100); ++i) {
      auto const s = source.sequence(source.random().between(0, 4));
      auto const turned = [](Edge const& e) { return Edge{e.right, e.left}; };
      PortalSequence back{turned(s.target), turned(s.source), {}, {}};
      for (auto const& f : s.occluders) back.occluders.push_back(turned(f));
      add_end_points(back);
      REQUIRE(has_sight_line(back) == has_sight_line(s));
      auto const mirror = [](Point3d const& p) { return Point3d{p.x, -p.y, p.z}; };
      auto const mirrored = [&](Edge const& e) { return Edge{mirror(e.right), mirror(e.left)}; };
      PortalSequence image{mirrored(s.source), mirrored(s.target), {}, {}};
      for (auto const& f : s.occluders) image.occluders.push_back(mirrored(f));
      add_end_points(image);
      REQUIRE(has_sight_line(image) == has_sight_line(s));
    }
  }
}

TEST_CASE("has_sight_line: a sight line above a sampled plan line is never denied", "[line_space][oracle]")
{
  for (PortalFamily const family : all_portal_families) {
    CAPTURE(name(family));
    PortalSource source(family, 85);
    int sampled = 0, exists = 0;
    for (int i = 0; i < trials(150); ++i) {
      CAPTURE(i);
      auto const s = source.sequence(source.random().between(0, 4));
      bool const expected = has_sight_line(s);
      exists += expected;
      bool found = false;
      for (int k = 0; k < 60 && !found; ++k) {
        auto const [p, q] = random_plan_line(s, source.random());
        found = some_sight_line_above(s, p, q);
      }
      if (found) REQUIRE(expected);
      sampled += found;
    }
    CAPTURE(sampled, exists);
    CHECK(sampled * 2 > exists);
  }
}

TEST_CASE("has_sight_line: what it denies is certified by subdivision of the cone", "[line_space][oracle]")
{
  int denied = 0, certified = 0;
  for (PortalFamily const family : all_portal_families) {
    CAPTURE(name(family));
    PortalSource source(family, 86);
    for (int i = 0; i < trials(60); ++i) {
      CAPTURE(i);
      auto const s = source.sequence(source.random().between(1, 3));
      bool const empty = certified_empty(s);
      if (empty) REQUIRE(!has_sight_line(s));
      denied += !has_sight_line(s);
      certified += empty;
    }
  }
  CAPTURE(denied, certified);
  CHECK(certified * 10 >= denied * 9);
}

TEST_CASE("QuadricSearch: portal sequences need rays and edges only", "[line_space][law]")
{
  using Search = QuadricSearch<ExactNumber>;
  int edges = 0;
  for (PortalFamily const family : all_portal_families) {
    PortalSource source(family, 87);
    for (int i = 0; i < trials(300); ++i) {
      auto const s = source.sequence(source.random().between(0, 5));
      auto const lines = portal_half_spaces<ExactNumber>(s, integer_frame(s));
      auto const cone = cone_with_interior(std::span<PluckerLine<ExactNumber> const>(lines));
      if (!cone) continue;
      Search const search(*cone);
      for (Sign const sign : {Sign::positive, Sign::negative})
        if (auto const found = search.find(sign)) {
          REQUIRE(found->stage != Search::Stage::faces);
          edges += found->stage == Search::Stage::edges;
        }
    }
  }
  CHECK(edges > 20);
}
