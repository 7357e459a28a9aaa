// Hunts for sight lines to what the oracle calls hidden.

#include "scenes.hpp"
#include "support/catch.hpp"
#include "support/height_field_slice.hpp"
#include "support/trials.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using oracle::Verdict;

namespace {

HeightField field(Random& random, int seed)
{
  switch (seed % 6) {
  case 0: return grid_field(random, 8, 8);
  case 1: return turned_field(random, 8, 12);
  case 2: return slanted_field(random, 8, 12);
  case 3: return crossing_field(random, 7, false);
  case 4: return crossing_field(random, 7, true);
  default: return slanted_grid_field(random, 8, 6);
  }
}

/// A point inside the polygon, mostly near one of its sides.
template <class P>
Point2q inner_point(std::vector<P> const& corners, Random& random)
{
  using Q = RationalNumber;
  Q x(0), y(0), weights(0);
  for (auto const& c : corners) {
    Q const w(random.chance(0.4) ? 1 : random.between(1, 1000));
    x += w * Q(c.x), y += w * Q(c.y), weights += w;
  }
  return {x / weights, y / weights};
}

}  // namespace

TEST_CASE("height field oracle: random sight lines end on visible objects only", "[height_field][conservative]")
{
  int seen = 0, visible = 0;
  for (int seed = 1; seed <= trials(40); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    HeightField const f = field(random, seed);
    auto const answer = oracle::visible_objects(f.columns, f.objects, f.cell);
    visible += int(std::ranges::count(answer.verdict, Verdict::visible));
    for (auto const& c : f.columns) {
      bool found = false;
      for (int i = 0; i < 300 && !(found && answer.verdict[c.object] == Verdict::visible); ++i) {
        Point2q const p = inner_point(f.cell.footprint, random);
        // A wall just below its top, or the top just inside a side.
        std::size_t const k = std::size_t(random.below(int(c.corners.size())));
        auto const &a = c.corners[k], &b = c.corners[(k + 1) % c.corners.size()];
        RationalNumber const t = RationalNumber(random.between(1, 99)) / 100, tiny(0x1p-20);
        auto const on_side = [&](double u, double v) -> RationalNumber {
          return RationalNumber(u) + t * (RationalNumber(v) - RationalNumber(u));
        };
        Point3q s{on_side(a.x, b.x), on_side(a.y, b.y), on_side(a.z, b.z)};
        if (random.chance(0.5)) {
          s.z -= tiny;
        } else {
          auto const& d = c.corners[(k + 2) % c.corners.size()];
          s = {s.x + tiny * (RationalNumber(d.x) - s.x), s.y + tiny * (RationalNumber(d.y) - s.y),
               s.z + tiny * (RationalNumber(d.z) - s.z)};
        }
        RationalNumber const top(f.cell.top), bottom(f.cell.bottom), down(random.chance(0.7) ? 0x1p-20 : 0.25);
        if (!oracle::confirms(f.columns, f.cell, {c.object, {p.x, p.y, top - down * (top - bottom)}, s})) continue;
        found = true;
        REQUIRE(answer.verdict[c.object] != Verdict::hidden);
      }
      seen += found ? 1 : 0;
    }
  }
  CAPTURE(seen, visible);
  CHECK(seen * 10 > visible * 8);  // the hunt would notice
}

TEST_CASE("height field oracle: lines close to two events of the plan show visible objects only",
          "[height_field][conservative]")
{
  using namespace oracle::detail;
  int seen = 0, visible = 0;
  RationalNumber const shrink(0x1p-60);
  for (int seed = 1; seed <= trials(24); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    HeightField const f = field(random, seed);
    auto const answer = oracle::visible_objects(f.columns, f.objects, f.cell);
    Plan const plan(f.columns, f.cell);
    Polygons const all = (polygon_bit(plan.columns) << 1) - 1;
    auto const near_event = [&] {
      Vector p = plan.events[std::size_t(random.below(int(plan.events.size())))].point;
      double const off = random.chance(0.5) ? 0x1p-12 : 0x1p-5;
      p.x = p.x + NT(random.uniform(-off, off)) * p.z, p.y = p.y + NT(random.uniform(-off, off)) * p.z;
      return p;
    };
    for (int target = 0; target < plan.columns; ++target) {
      auto const object = f.columns[std::size_t(target)].object;
      auto const verdict = answer.verdict[object];
      auto const good = [&](std::optional<Witness> w) {
        return w && (w->object = object, oracle::confirms(f.columns, f.cell, *w));
      };
      visible += verdict == Verdict::visible ? 1 : 0;
      for (int i = 0; i < (verdict == Verdict::visible ? 40 : 400); ++i) {
        Vector const line = cross(near_event(), near_event());
        View const view = view_along(plan, line, target, all, shrink);
        bool found = good(view.from_above);
        for (auto const& c : view.candidates) found = found || good(sight_line(plan, line, c, shrink));
        if (!found) continue;
        REQUIRE(verdict != Verdict::hidden);
        ++seen;
        break;
      }
    }
  }
  CAPTURE(seen, visible);
  CHECK(seen * 10 > visible * 5);
}

TEST_CASE("height field oracle: three columns hide together what no two of them hide", "[height_field]")
{
  int found = 0;
  for (int seed = 1; found < 10; ++seed) {
    REQUIRE(seed < 500);
    Random random(static_cast<std::uint64_t>(seed));
    HeightField f{{}, 4, unit_cell};
    std::uint32_t const goal = 3;
    for (std::uint32_t i = 0; i < goal; ++i) {
      auto const at = [&](double x, double y) {
        return Point3d{x + random.uniform(-0.2, 0.2), y + random.uniform(-0.1, 0.1), random.uniform(2, 4)};
      };
      double const y = 0.1 + 0.4 * i;
      f.columns.push_back(triangle(i, at(4, y), at(6, y - 0.35), at(6, y + 0.35)));
    }
    f.columns.push_back(box(goal, 9, 0, 10, 1, random.uniform(0, 2)));
    auto const hidden = [&](HeightField const& g) {
      return oracle::visible_objects(g.columns, g.objects, g.cell).verdict[goal] == Verdict::hidden;
    };
    if (!hidden(f)) continue;
    bool each_needed = true;
    for (std::ptrdiff_t i = 0; i < 3; ++i) {
      HeightField g = f;
      g.columns.erase(g.columns.begin() + i);
      each_needed = each_needed && !hidden(g);
    }
    found += each_needed ? 1 : 0;
  }
}

TEST_CASE("height field oracle: what is no sight line is not confirmed", "[height_field]")
{
  std::vector<Column> const columns{box(0, 4, 0, 5, 1, 3), box(1, 3, 0, 4, 0.5, 2)};
  auto const confirmed = [&](Point3d p, Point3d s, std::uint32_t object = 0) {
    return oracle::confirms(columns, unit_cell, {object, exact(p), exact(s)});
  };
  CHECK(confirmed({0.5, 0.75, 0.5}, {4, 0.75, 0.5}));
  CHECK_FALSE(confirmed({0.5, 0.75, 0.5}, {4, 0.75, 0.5}, 1));  // another's face
  CHECK_FALSE(confirmed({0.5, 0.75, 0}, {4, 0.75, 0.5}));       // from the cell's boundary
  CHECK_FALSE(confirmed({0, 0.75, 0.5}, {4, 0.75, 0.5}));
  CHECK_FALSE(confirmed({0.5, 0.75, 0.5}, {4, 0.75, 3}));  // an edge
  CHECK_FALSE(confirmed({0.5, 0.75, 0.5}, {4, 1, 0.5}));
  CHECK_FALSE(confirmed({0.5, 0.75, 0.5}, {4, 0.25, 0.5}));  // through the other
  CHECK_FALSE(confirmed({0.5, 0.5, 0.5}, {4, 0.5, 0.5}));    // along its side
  CHECK_FALSE(confirmed({0.5, 0.75, 0.5}, {5, 0.75, 0.5}));  // through the column itself
  CHECK(confirmed({0.5, 0.25, 0.5}, {3, 0.25, -100}, 1));
}
