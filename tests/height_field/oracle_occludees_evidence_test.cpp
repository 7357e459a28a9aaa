// Hunts for sight lines to the occludees that the oracle calls hidden.

#include "occludees.hpp"
#include "scenes.hpp"
#include "support/catch.hpp"
#include "support/height_field_occludees.hpp"
#include "support/height_field_polygon.hpp"
#include "support/height_field_slice.hpp"
#include "support/trials.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using oracle::Occludee;
using oracle::Verdict;

namespace {

struct Case {
  std::vector<Column> columns;
  std::vector<Occludee> occludees;
  Cell cell;
};

/// Many columns, often high, so that much is hidden.
Case make_case(HeightScene kind, Random& random)
{
  for (;;) {
    auto const scene = height_case(random, kind, random.between(5, 12));
    Case c{oracle_columns(visibility::HeightField(scene.scene)), {}, oracle_cell(scene.cell)};
    try {
      oracle::validate(c.columns, scene.scene.objects.size(), c.cell);
    } catch (std::invalid_argument const&) {
      continue;  // a column reaches the cell's top
    }
    c.occludees = random_occludees(kind, random, c.columns, c.cell, 5);
    return c;
  }
}

/// A point of the corners' hull, mostly near one of its corners or sides; in its relative interior if they turn.
Point3q weighted(std::vector<Point3d> const& corners, Random& random)
{
  using Q = RationalNumber;
  Point3q sum{Q(0), Q(0), Q(0)};
  Q weights(0);
  int const small = random.chance(0.5) ? 1 : 100;
  for (auto const& c : corners) {
    Q const w(random.chance(0.5) ? small : random.between(1, 100000));
    sum = {sum.x + w * Q(c.x), sum.y + w * Q(c.y), sum.z + w * Q(c.z)};
    weights += w;
  }
  return {sum.x / weights, sum.y / weights, sum.z / weights};
}

}  // namespace

TEST_CASE("occludees: random sight lines end on visible ones only, every witness is one",
          "[height_field][conservative]")
{
  int seen = 0, visible = 0, hidden = 0;
  for (auto const kind : height_scenes)
    for (int seed = 1; seed <= trials(7); ++seed) {
      CAPTURE(int(kind), seed);
      Random random(static_cast<std::uint64_t>(1000 * int(kind) + seed));
      Case const c = make_case(kind, random);
      auto const answer = oracle::visible_occludees(c.columns, c.occludees, c.cell);
      for (std::size_t i = 0; i < c.occludees.size(); ++i) {
        auto const& occludee = c.occludees[i];
        auto const verdict = answer.verdict[i];
        CAPTURE(i);
        if (answer.witness[i]) {
          REQUIRE(verdict == Verdict::visible);
          REQUIRE(oracle::confirms(c.columns, occludee, c.cell, *answer.witness[i]));
        } else {
          REQUIRE((verdict != Verdict::visible || oracle::meets(occludee, c.cell)));
        }
        (verdict == Verdict::visible ? visible : hidden) += 1;
        bool found = oracle::meets(occludee, c.cell);
        for (int n = verdict == Verdict::visible ? 100 : 400; n > 0 && !found; --n) {
          std::vector<Point3d> roof;
          for (auto const& p : c.cell.footprint) roof.push_back({p.x, p.y, c.cell.top});
          Point3q from = weighted(roof, random);
          RationalNumber const down(random.chance(0.7) ? 0x1p-20 : 0.25);
          from.z -= down * (RationalNumber(c.cell.top) - RationalNumber(c.cell.bottom));
          auto const& polygon = occludee.polygons[std::size_t(random.below(int(occludee.polygons.size())))];
          found = oracle::confirms(c.columns, occludee, c.cell, {0, from, weighted(polygon, random)});
        }
        seen += found ? 1 : 0;
        REQUIRE((!found || verdict != Verdict::hidden));
      }
    }
  CAPTURE(seen, visible, hidden);
  CHECK(seen * 10 > visible * 8);  // the hunt would notice
  CHECK(hidden > trials(50));
}

TEST_CASE("occludees: lines close to two events of the plan show visible ones only", "[height_field][conservative]")
{
  using namespace oracle::detail;
  int seen = 0, visible = 0;
  RationalNumber const shrink(0x1p-60);
  for (auto const kind : height_scenes)
    for (int seed = 1; seed <= trials(4); ++seed) {
      CAPTURE(int(kind), seed);
      Random random(static_cast<std::uint64_t>(77000 + 1000 * int(kind) + seed));
      Case const c = make_case(kind, random);
      auto const answer = oracle::visible_occludees(c.columns, c.occludees, c.cell);
      for (std::size_t i = 0; i < c.occludees.size(); ++i) {
        auto const& occludee = c.occludees[i];
        if (oracle::meets(occludee, c.cell)) continue;
        bool found = false;
        for (auto const& polygon : occludee.polygons) {
          if (!has_area(polygon)) continue;
          for (auto const& target : targets(polygon)) {
            Plan const plan(c.columns, c.cell, target);
            Polygons const all = polygon_bit(plan.polygon_count()) - 1;
            auto const near_event = [&] {
              Vector p = plan.events[std::size_t(random.below(int(plan.events.size())))].point;
              double const off = random.chance(0.5) ? 0x1p-12 : 0x1p-5;
              p.x = p.x + NT(random.uniform(-off, off)) * p.z, p.y = p.y + NT(random.uniform(-off, off)) * p.z;
              return p;
            };
            auto const good = [&](std::optional<Witness> const& w) {
              return w && oracle::confirms(c.columns, occludee, c.cell, *w);
            };
            for (int n = answer.verdict[i] == Verdict::visible ? 120 : 300; n > 0 && !found; --n) {
              Vector const line = cross(near_event(), near_event());
              View const view = view_along(plan, line, plan.target(), all, shrink);
              found = good(view.from_above);
              for (auto const& candidate : view.candidates)
                found = found || good(sight_line(plan, line, candidate, shrink));
            }
          }
        }
        visible += answer.verdict[i] == Verdict::visible ? 1 : 0;
        seen += found ? 1 : 0;
        REQUIRE((!found || answer.verdict[i] != Verdict::hidden));
      }
    }
  CAPTURE(seen, visible);
  CHECK(seen * 10 > visible * 4);
}
