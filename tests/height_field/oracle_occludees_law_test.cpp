// Occludees: what must not change the answer, what may change it in one direction only, and what they say about
// columns.

#include "occludees.hpp"
#include "scenes.hpp"
#include "support/catch.hpp"
#include "support/height_field_occludees.hpp"
#include "support/trials.hpp"

#include <algorithm>
#include <functional>
#include <ranges>

using namespace visibility;
using namespace visibility::test;
using oracle::Occludee;
using oracle::Verdict;

namespace {

using Verdicts = std::vector<Verdict>;

struct Case {
  std::vector<Column> columns;
  std::size_t objects = 0;
  std::vector<Occludee> occludees;
  Cell cell;
};

Verdicts decide(Case const& c) { return oracle::visible_occludees(c.columns, c.occludees, c.cell).verdict; }

Case make_case(HeightScene kind, Random& random)
{
  for (;;) {
    auto const scene = height_case(random, kind, random.between(2, 7));
    Case c{
      oracle_columns(visibility::HeightField(scene.scene)), scene.scene.objects.size(), {}, oracle_cell(scene.cell)};
    try {
      oracle::validate(c.columns, c.objects, c.cell);
    } catch (std::invalid_argument const&) {
      continue;  // a column reaches the cell's top
    }
    c.occludees = random_occludees(kind, random, c.columns, c.cell, 4);
    return c;
  }
}

/// Calls check(case, verdicts, random) for scenes of every kind; some occludees must be hidden, hardly any undecided.
void for_each_case(int cases, std::function<void(Case const&, Verdicts const&, Random&)> const& check)
{
  int hidden = 0, visible = 0, undecided = 0;
  for (auto const kind : height_scenes)
    for (int seed = 1; seed <= trials(cases); ++seed) {
      CAPTURE(int(kind), seed);
      Random random(static_cast<std::uint64_t>(1000 * int(kind) + seed));
      Case const c = make_case(kind, random);
      Verdicts const verdicts = decide(c);
      hidden += int(std::ranges::count(verdicts, Verdict::hidden));
      visible += int(std::ranges::count(verdicts, Verdict::visible));
      undecided += int(std::ranges::count(verdicts, Verdict::undecided));
      check(c, verdicts, random);
    }
  CAPTURE(hidden, visible, undecided);
  CHECK(hidden * 10 > visible);
  CHECK(visible * 10 > hidden);
  CHECK(undecided * 50 <= hidden + visible);
}

/// Equal, as far as decided.
bool agree(Verdicts const& a, Verdicts const& b)
{
  return std::ranges::equal(
    a, b, [](Verdict x, Verdict y) { return x == y || x == Verdict::undecided || y == Verdict::undecided; });
}

/// What is visible in a is not hidden in b.
bool keeps(Verdicts const& a, Verdicts const& b)
{
  return std::ranges::equal(a, b, [](Verdict x, Verdict y) { return x != Verdict::visible || y != Verdict::hidden; });
}

/// The surface of each object: tops, and walls down to the cell's bottom and beyond.
std::vector<Occludee> surfaces(Case const& c)
{
  std::vector<Occludee> out(c.objects);
  for (auto const& column : c.columns) {
    auto& polygons = out[column.object].polygons;
    polygons.push_back(column.corners);
    for (std::size_t i = 0, n = column.corners.size(); i < n; ++i) {
      auto const &a = column.corners[i], &b = column.corners[(i + 1) % n];
      double const low = std::min({a.z, b.z, c.cell.bottom}) - 1;
      polygons.push_back({{a.x, a.y, low}, {b.x, b.y, low}, b, a});
    }
  }
  return out;
}

}  // namespace

TEST_CASE("occludees: the surface of a column is visible iff the column is", "[height_field][law][oracle]")
{
  for_each_case(14, [](Case const& c, Verdicts const&, Random&) {
    Case on = c;
    on.occludees = surfaces(c);
    REQUIRE(agree(oracle::visible_objects(c.columns, c.objects, c.cell).verdict, decide(on)));
  });
}

TEST_CASE("occludees: a box around a visible column is visible", "[height_field][law]")
{
  for_each_case(8, [](Case const& c, Verdicts const&, Random&) {
    double const margin = c.cell.top > 0.1 ? 0.125 : 0.000125;  // millimetres or not
    auto const of_columns = oracle::visible_objects(c.columns, c.objects, c.cell).verdict;
    for (auto const& column : c.columns) {
      if (of_columns[column.object] != Verdict::visible) continue;
      auto const [x0, x1] = std::ranges::minmax(column.corners | std::views::transform(&Point3d::x));
      auto const [y0, y1] = std::ranges::minmax(column.corners | std::views::transform(&Point3d::y));
      double const top = std::ranges::max(column.corners | std::views::transform(&Point3d::z));
      Case around{{box(0, x0 - margin, y0 - margin, x1 + margin, y1 + margin, top + margin)}, 1, {}, c.cell};
      auto const eye = c.cell.footprint[0];
      if (x0 < eye.x && eye.x < x1 && y0 < eye.y && eye.y < y1) continue;  // inside
      around.occludees = surfaces(around);
      around.columns = c.columns;
      REQUIRE(decide(around)[0] != Verdict::hidden);
    }
  });
}

TEST_CASE("occludees: order, first corners and orientation do not matter", "[height_field][law]")
{
  for_each_case(10, [](Case const& c, Verdicts const& verdicts, Random& random) {
    Case g = c;
    for (auto& o : g.occludees)
      for (auto& p : o.polygons) {
        std::ranges::rotate(p, p.begin() + random.below(int(p.size())));
        if (random.chance(0.5)) std::ranges::reverse(p);
      }
    std::ranges::reverse(g.columns);
    REQUIRE(agree(verdicts, decide(g)));
    std::ranges::reverse(g.occludees);
    auto turned = verdicts;
    std::ranges::reverse(turned);
    REQUIRE(agree(turned, decide(g)));
  });
}

TEST_CASE("occludees: mirrored and turned scenes", "[height_field][law]")
{
  auto const mapped = [](Case c, std::function<void(double&, double&)> const& map) {
    for (auto& column : c.columns) {
      for (auto& p : column.corners) map(p.x, p.y);
      std::ranges::reverse(column.corners);
    }
    for (auto& o : c.occludees)
      for (auto& polygon : o.polygons)
        for (auto& p : polygon) map(p.x, p.y);
    for (auto& p : c.cell.footprint) map(p.x, p.y);
    std::ranges::reverse(c.cell.footprint);
    return c;
  };
  for_each_case(8, [&](Case const& c, Verdicts const& verdicts, Random&) {
    REQUIRE(agree(verdicts, decide(mapped(c, [](double& x, double&) { x = -x; }))));
    REQUIRE(agree(verdicts, decide(mapped(c, [](double& x, double& y) { std::swap(x, y); }))));
  });
}

TEST_CASE("occludees: a polygon may be cut in two", "[height_field][law]")
{
  for_each_case(12, [](Case const& c, Verdicts const& verdicts, Random& random) {
    Case g = c;
    for (auto& o : g.occludees) {
      std::vector<Polygon> parts;
      for (auto const& p : o.polygons) {
        if (p.size() == 3) {
          parts.push_back(p);
          continue;
        }
        auto const k = std::ptrdiff_t(random.between(2, int(p.size()) - 2));
        parts.emplace_back(p.begin(), p.begin() + k + 1);
        parts.emplace_back(p.begin() + k, p.end());
        parts.back().push_back(p[0]);
      }
      o.polygons = parts;
    }
    REQUIRE(agree(verdicts, decide(g)));
  });
}

TEST_CASE("occludees: more columns never show more", "[height_field][law]")
{
  for_each_case(10, [](Case const& c, Verdicts const& verdicts, Random& random) {
    Case g = c;
    g.columns.erase(g.columns.begin() + random.below(int(g.columns.size())));
    REQUIRE(keeps(verdicts, decide(g)));
    g = c;
    for (auto& p : g.columns[0].corners) p.z -= 0.125;
    REQUIRE(keeps(verdicts, decide(g)));
  });
}

TEST_CASE("occludees: a larger cell never shows less", "[height_field][law]")
{
  int compared = 0;
  for_each_case(10, [&](Case const& c, Verdicts const& verdicts, Random& random) {
    Case g = c;
    g.cell.top += random.uniform(0, c.cell.top);
    g.cell.bottom -= random.uniform(0, 1);
    REQUIRE(keeps(verdicts, decide(g)));
    // Outwards by a tenth, from the middle of the footprint.
    g = c;
    Point2d middle{0, 0};
    for (auto const& p : c.cell.footprint) middle = {middle.x + p.x / 4, middle.y + p.y / 4};
    for (auto& p : g.cell.footprint) p = {p.x + (p.x - middle.x) / 10, p.y + (p.y - middle.y) / 10};
    Verdicts wider;
    try {
      wider = decide(g);
    } catch (std::invalid_argument const&) {
      return;  // it has grown into a column
    }
    REQUIRE(keeps(verdicts, wider));
    ++compared;
  });
  CHECK(compared > trials(20));
}

TEST_CASE("occludees: several polygons together are visible iff one is alone", "[height_field][law]")
{
  for_each_case(10, [](Case const& c, Verdicts const& verdicts, Random&) {
    Case g = c;
    for (auto const& o : c.occludees)
      for (auto const& p : o.polygons) g.occludees[0].polygons.push_back(p);
    Verdict const joined = decide(g)[0];
    bool const some = std::ranges::find(verdicts, Verdict::visible) != verdicts.end();
    bool const unknown = std::ranges::find(verdicts, Verdict::undecided) != verdicts.end();
    if (joined != Verdict::undecided && !(unknown && !some)) REQUIRE((joined == Verdict::visible) == some);
  });
}
