// What must not change the answer, and what may change it in one direction only.

#include "scenes.hpp"
#include "support/catch.hpp"
#include "support/trials.hpp"

#include <algorithm>
#include <functional>

using namespace visibility;
using namespace visibility::test;
using oracle::Verdict;

namespace {

using Verdicts = std::vector<Verdict>;

Verdicts decide(HeightField const& f) { return oracle::visible_objects(f.columns, f.objects, f.cell).verdict; }

std::vector<std::pair<std::string, std::function<HeightField(Random&)>>> const families{
  {"grid", [](Random& r) { return grid_field(r, r.between(2, 8), 8); }},
  {"turned", [](Random& r) { return turned_field(r, r.between(2, 8), 12); }},
  {"slanted", [](Random& r) { return slanted_field(r, r.between(2, 8), 12); }},
  {"slanted grid", [](Random& r) { return slanted_grid_field(r, r.between(2, 8), 6); }},
  {"crossing", [](Random& r) { return crossing_field(r, r.between(3, 7), false); }},
  {"crossing grid", [](Random& r) { return crossing_field(r, r.between(3, 7), true); }}};

/// Calls check(field, verdicts, random) for scenes of every family; some objects must be hidden, hardly any undecided.
void for_each_scene(int scenes, std::function<void(HeightField const&, Verdicts const&, Random&)> const& check)
{
  for (auto const& [name, make] : families) {
    std::size_t hidden = 0, undecided = 0, all = 0;
    for (int seed = 1; seed <= trials(scenes); ++seed) {
      CAPTURE(name, seed);
      Random random(static_cast<std::uint64_t>(seed));
      HeightField const f = make(random);
      Verdicts const verdicts = decide(f);
      hidden += std::size_t(std::ranges::count(verdicts, Verdict::hidden));
      undecided += std::size_t(std::ranges::count(verdicts, Verdict::undecided));
      all += verdicts.size();
      check(f, verdicts, random);
    }
    CAPTURE(name, hidden, undecided, all);
    CHECK(hidden * 30 > all);
    CHECK(undecided * 1000 <= all);
  }
}

/// Equal but for what one of them leaves undecided.
bool agree(Verdicts const& a, Verdicts const& b)
{
  return std::ranges::equal(
    a, b, [](Verdict x, Verdict y) { return x == y || x == Verdict::undecided || y == Verdict::undecided; });
}

/// Whether nothing that is visible in `a` is hidden in `b`.
bool keeps(Verdicts const& a, Verdicts const& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] == Verdict::visible && b[i] == Verdict::hidden) return false;
  return true;
}

void shuffle(std::vector<Column>& columns, Random& random)
{
  for (std::size_t i = columns.size(); i > 1; --i)
    std::swap(columns[i - 1], columns[std::size_t(random.below(int(i)))]);
}

/// The same under a map of the plane; `mirror` says that it turns polygons over.
HeightField mapped(HeightField f, std::function<void(double&, double&)> const& map, bool mirror)
{
  for (auto& c : f.columns) {
    for (auto& p : c.corners) map(p.x, p.y);
    if (mirror) std::ranges::reverse(c.corners);
  }
  for (auto& p : f.cell.footprint) map(p.x, p.y);
  if (mirror) std::ranges::reverse(f.cell.footprint);
  return f;
}

}  // namespace

TEST_CASE("height field oracle: order of columns and first corners do not matter", "[height_field][law]")
{
  for_each_scene(40, [](HeightField const& f, Verdicts const& verdicts, Random& random) {
    HeightField g = f;
    shuffle(g.columns, random);
    for (auto& c : g.columns) std::ranges::rotate(c.corners, c.corners.begin() + random.below(int(c.corners.size())));
    std::ranges::rotate(g.cell.footprint, g.cell.footprint.begin() + random.below(4));
    REQUIRE(agree(verdicts, decide(g)));
  });
}

TEST_CASE("height field oracle: mirrored and turned scenes", "[height_field][law]")
{
  for_each_scene(40, [](HeightField const& f, Verdicts const& verdicts, Random&) {
    REQUIRE(agree(verdicts, decide(mapped(
                              f, [](double& x, double&) { x = -x; }, true))));
    REQUIRE(agree(verdicts, decide(mapped(
                              f, [](double& x, double& y) { std::swap(x, y); }, true))));
    REQUIRE(agree(verdicts, decide(mapped(
                              f, [](double& x, double& y) { x *= 0x1p20, y *= -0x1p-20; }, true))));
  });
}

TEST_CASE("height field oracle: far from the origin", "[height_field][law]")
{
  for (int seed = 1; seed <= trials(60); ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    HeightField const f = grid_field(random, 7, 8);
    auto const away = [](double& x, double& y) { x += 954321, y -= 1843210; };
    REQUIRE(agree(decide(f), decide(mapped(f, away, false))));
  }
}

TEST_CASE("height field oracle: a column may be cut into abutting pieces", "[height_field][law]")
{
  for_each_scene(40, [](HeightField const& f, Verdicts const& verdicts, Random& random) {
    HeightField g = f;
    g.columns.clear();
    for (auto const& c : f.columns) {
      // By a diagonal: exact for any corners.
      if (c.corners.size() == 4 && random.chance(0.5)) {
        g.columns.push_back({{c.corners[0], c.corners[1], c.corners[2]}, c.object, {false, false, true}});
        g.columns.push_back({{c.corners[0], c.corners[2], c.corners[3]}, c.object, {true, false, false}});
      } else {
        g.columns.push_back(c);
      }
    }
    REQUIRE(agree(verdicts, decide(g)));
    // And a copy of a column as a part of the same object.
    g.columns.push_back(f.columns[0]);
    REQUIRE(agree(verdicts, decide(g)));
  });
}

TEST_CASE("height field oracle: fewer columns hide no more", "[height_field][law]")
{
  for_each_scene(40, [](HeightField const& f, Verdicts const& verdicts, Random& random) {
    HeightField g = f;
    std::size_t const gone = std::size_t(random.below(int(f.columns.size())));
    g.columns.erase(g.columns.begin() + std::ptrdiff_t(gone));
    Verdicts expected = verdicts;
    expected[gone] = Verdict::hidden;
    REQUIRE(keeps(expected, decide(g)));
  });
}

TEST_CASE("height field oracle: a higher cell sees no less, a raised column is seen no less", "[height_field][law]")
{
  for_each_scene(40, [](HeightField const& f, Verdicts const& verdicts, Random& random) {
    HeightField g = f;
    g.cell.top += random.uniform(0, 2);
    REQUIRE(keeps(verdicts, decide(g)));
    g = f;
    std::size_t const i = std::size_t(random.below(int(f.columns.size())));
    for (auto& p : g.columns[i].corners) p.z += 0.125;
    try {
      REQUIRE((verdicts[i] != Verdict::visible || decide(g)[i] != Verdict::hidden));
    } catch (std::invalid_argument const&) {  // it has grown into the cell's top
    }
  });
}

TEST_CASE("height field oracle: raised step by step, a column appears once, with no doubt around the step",
          "[height_field][law][degenerate]")
{
  int steps = 0, undecided = 0;
  for (auto const& [name, make] : families)
    for (int seed = 1; seed <= trials(6); ++seed) {
      CAPTURE(name, seed);
      Random random(static_cast<std::uint64_t>(seed));
      HeightField f = make(random);
      auto const verdicts = decide(f);
      auto const found = std::ranges::find(verdicts, Verdict::hidden);
      if (found == verdicts.end()) continue;
      auto& column = f.columns[std::size_t(found - verdicts.begin())];
      auto const base = column;
      auto const lifted = [&](double by) {
        for (std::size_t i = 0; i < base.corners.size(); ++i) column.corners[i].z = base.corners[i].z + by;
        return decide(f)[base.object];
      };
      if (lifted(32) != Verdict::visible) continue;
      double low = 0, high = 32;
      while (high - low > 1e-12) {
        double const middle = low + (high - low) / 2;
        auto const v = lifted(middle);
        ++steps;
        if (v == Verdict::undecided) ++undecided;
        (v == Verdict::visible ? high : low) = middle;
      }
      CHECK(lifted(high + 1e-9) == Verdict::visible);
      CHECK(lifted(high + 1) == Verdict::visible);
    }
  CAPTURE(steps, undecided);
  CHECK(steps > 100);
  CHECK(undecided * 50 <= steps);
}
