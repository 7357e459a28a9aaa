// Where the edges of tops are seen, against what is known of columns and occludees, and against random sight lines.

#include "occludees.hpp"
#include "parts.hpp"
#include "scenes.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using oracle::Crossing;
using oracle::Verdict;
using Q = RationalNumber;

namespace {

constexpr auto entering = Crossing::entering, leaving = Crossing::leaving;

/// On which side of the column the point of its wall lies, and where along it.
std::pair<std::size_t, Q> position(Column const& c, Point3q const& s)
{
  for (std::size_t i = 0, n = c.corners.size(); i < n; ++i) {
    Point3q const a = exact(c.corners[i]), b = exact(c.corners[(i + 1) % n]);
    if ((b.x - a.x) * (s.y - a.y) != (b.y - a.y) * (s.x - a.x)) continue;
    Q const t = a.x != b.x ? Q((s.x - a.x) / (b.x - a.x)) : Q((s.y - a.y) / (b.y - a.y));
    if (t > 0 && t < 1) return {i, t};
  }
  return {c.corners.size(), Q(0)};
}

HeightField field(Random& random, int seed)
{
  switch (seed % 6) {
  case 0: return grid_field(random, 7, 6);
  case 1: return turned_field(random, 7, 12);
  case 2: return slanted_field(random, 7, 12);
  case 3: return crossing_field(random, 5, false);
  case 4: return crossing_field(random, 5, true);
  default: return slanted_grid_field(random, 7, 6);
  }
}

}  // namespace

TEST_CASE("edges: seen where a witness ends below them; a column with a visible edge is visible",
          "[height_field][parts][law][oracle]")
{
  int walls = 0, visible = 0, hidden = 0;
  for (int seed = 1; seed <= trials(10); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    HeightField const f = field(random, seed);
    auto const answer = oracle::visible_objects(f.columns, f.objects, f.cell);
    for (std::size_t i = 0; i < f.columns.size(); ++i) {
      auto const& c = f.columns[i];
      auto const& w = answer.witness[c.object];
      CAPTURE(i);
      if (w)
        if (auto const [side, t] = position(c, w->to); side < c.corners.size()) {
          REQUIRE(sees(f.columns, i, side, entering, t, f.cell));
          ++walls;
        }
      for (std::size_t side = 0; side < c.corners.size(); ++side)
        for (auto const crossing : {entering, leaving}) {
          bool const seen = sees(f.columns, i, side, crossing, Q(random.between(1, 1022)) / 1023, f.cell);
          (seen ? visible : hidden) += 1;
          REQUIRE((!seen || answer.verdict[c.object] == Verdict::visible));
        }
    }
  }
  CAPTURE(walls, visible, hidden);
  CHECK(walls > trials(8));
  CHECK(visible > trials(30));
  CHECK(hidden > trials(80));
}

TEST_CASE("edges: seen where a fence on the wall below or a strip of the top is", "[height_field][parts][law][oracle]")
{
  int visible = 0, hidden = 0;
  for (int seed = 1; seed <= trials(16); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    HeightField const f = grid_field(random, random.between(3, 8), 5);
    for (int tries = 0; tries < 6; ++tries) {
      std::size_t const i = std::size_t(random.below(int(f.columns.size()))), side = std::size_t(random.below(4));
      auto const& c = f.columns[i];
      auto const a = c.corners[side], b = c.corners[(side + 1) % 4], d = c.corners[(side + 2) % 4];
      CAPTURE(i, side);
      // Between two positions of a grid of 64: exact.
      int const first = random.between(0, 60), last = first + random.between(1, 3);
      auto const at = [&](int k, Point3d const& p, Point3d const& q) {
        return Point2d{p.x + (q.x - p.x) * k / 64, p.y + (q.y - p.y) * k / 64};
      };
      Point2d const p = at(first, a, b), q = at(last, a, b);
      double const in_x = (d.x - b.x) / 1024, in_y = (d.y - b.y) / 1024;
      std::vector<oracle::Occludee> const parts{
        {{upright(p, q, a.z - 0x1p-10, a.z)}},
        {{{{p.x, p.y, a.z}, {q.x, q.y, a.z}, {q.x + in_x, q.y + in_y, a.z}, {p.x + in_x, p.y + in_y, a.z}}}}};
      auto const answer = oracle::visible_occludees(f.columns, parts, f.cell);
      for (auto const crossing : {entering, leaving}) {
        std::size_t const part = crossing == entering ? 0 : 1;
        bool some = false;
        for (int k = 0; k < 4; ++k) {
          Q const t = (Q(first) + Q(random.between(1, 98)) / 99 * Q(last - first)) / 64;
          some = some || sees(f.columns, i, side, crossing, t, f.cell);
        }
        REQUIRE((!some || answer.verdict[part] != Verdict::hidden));
        (some ? visible : hidden) += 1;
        if (auto const& w = answer.witness[part]; w && crossing == entering)
          REQUIRE(sees(f.columns, i, side, crossing, position(c, w->to).second, f.cell));
      }
    }
  }
  CAPTURE(visible, hidden);
  CHECK(visible > trials(10));
  CHECK(hidden > trials(10));
}

TEST_CASE("edges: random sight lines reach visible positions only", "[height_field][parts][conservative]")
{
  int found = 0, visible = 0, hidden = 0;
  for (int seed = 1; seed <= trials(18); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(9000 + seed));
    HeightField const f = field(random, seed);
    for (int tries = 0; tries < 10; ++tries) {
      std::size_t const i = std::size_t(random.below(int(f.columns.size())));
      auto const& c = f.columns[i];
      std::size_t const n = c.corners.size(), side = std::size_t(random.below(int(n)));
      auto const crossing = random.chance(0.5) ? entering : leaving;
      Q const t = Q(random.between(1, 1022)) / 1023, tiny(0x1p-30);
      CAPTURE(i, side, int(crossing));
      auto const e = between(exact(c.corners[side]), exact(c.corners[(side + 1) % n]), t);
      bool const seen = sees(f.columns, i, side, crossing, t, f.cell);
      (seen ? visible : hidden) += 1;
      bool reached = false;
      for (int k = 0; k < 80 && !reached; ++k) {
        Point3q eye{Q(0), Q(0), Q(f.cell.top) - (random.chance(0.7) ? tiny : Q(0.25))};
        Q weights(0);
        for (auto const& p : f.cell.footprint) {
          Q const w(random.chance(0.4) ? 1 : random.between(1, 1000));
          eye.x += w * Q(p.x), eye.y += w * Q(p.y), weights += w;
        }
        eye.x /= weights, eye.y /= weights;
        Point3q to = e;
        if (crossing == entering) {
          to.z -= tiny;
        } else {
          to.x += tiny * (eye.x - e.x), to.y += tiny * (eye.y - e.y);
          Column const& own = c;  // the height of its plane there
          if (own.corners.size() == 3) {
            Point3q const a = exact(own.corners[0]), b = exact(own.corners[1]), d = exact(own.corners[2]);
            Q const bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z, dx = d.x - a.x, dy = d.y - a.y, dz = d.z - a.z;
            Q const x = to.x - a.x, y = to.y - a.y, area = bx * dy - by * dx;
            to.z = a.z + ((x * dy - y * dx) * bz + (bx * y - by * x) * dz) / area;
          }
        }
        auto columns = f.columns;
        for (auto& other : columns) other.object = 0;
        columns[i].object = 1;
        reached = oracle::confirms(columns, f.cell, {1, eye, to});
        if (reached && crossing == leaving) reached = position(c, to).first == n;  // on the top, not on another wall
      }
      REQUIRE((!reached || seen));
      found += reached ? 1 : 0;
    }
  }
  CAPTURE(found, visible, hidden);
  CHECK(found * 10 > visible * 7);  // the hunt would notice
  CHECK(hidden > trials(18));
}

TEST_CASE("edges: more columns never show more, mirrored scenes show the same", "[height_field][parts][law]")
{
  for (int seed = 1; seed <= trials(18); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(5000 + seed));
    HeightField const f = field(random, seed);
    for (std::size_t i = 1; i < f.columns.size(); ++i) {
      std::size_t const n = f.columns[i].corners.size(), side = std::size_t(random.below(int(n)));
      auto const crossing = random.chance(0.5) ? entering : leaving;
      Q const t = Q(random.between(1, 1022)) / 1023;
      bool const seen = sees(f.columns, i, side, crossing, t, f.cell);
      std::vector<Column> const fewer(f.columns.begin() + 1, f.columns.end());
      REQUIRE((!seen || sees(fewer, i - 1, side, crossing, t, f.cell)));
      auto mirrored = f;
      for (auto& c : mirrored.columns) {
        for (auto& p : c.corners) p.x = -p.x;
        std::ranges::reverse(c.corners);
      }
      for (auto& p : mirrored.cell.footprint) p.x = -p.x;
      std::ranges::reverse(mirrored.cell.footprint);
      REQUIRE(seen == sees(mirrored.columns, i, (2 * n - 2 - side) % n, crossing, 1 - t, mirrored.cell));
    }
  }
}
