#include "support/catch.hpp"
#include "support/height_field_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/methods/exact_25d/method.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {

std::vector<bool> members(PotentiallyVisibleSet const& set, std::size_t n)
{
  std::vector<bool> out(n);
  for (auto const o : set.visible) out[o] = true;
  return out;
}

/// What a comparison met.
struct Verdicts {
  int undecided = 0, visible = 0, hidden = 0;
};

/// Compares the set with the oracle's, if a column does not reach the cell's top.
void compare(HeightCase const& c, Verdicts& met)
{
  HeightField const field(c.scene);
  auto const columns = oracle_columns(field);
  oracle::Answer answer;
  try {
    answer = oracle::visible_objects(columns, c.scene.objects.size(), oracle_cell(c.cell));
  } catch (std::invalid_argument const&) {
    return;
  }
  auto const set = Exact25d<Filtered>()(field, ViewCell::hull(c.cell));
  auto const is_visible = members(set, c.scene.objects.size());
  REQUIRE(set.guarantee == Guarantee::exact);
  for (std::size_t o = 0; o < is_visible.size(); ++o) {
    CAPTURE(o);
    switch (answer.verdict[o]) {
    case oracle::Verdict::visible:
      CHECK(is_visible[o]);
      ++met.visible;
      break;
    case oracle::Verdict::hidden:
      CHECK(!is_visible[o]);
      ++met.hidden;
      break;
    case oracle::Verdict::undecided: ++met.undecided; break;
    }
  }
}

}  // namespace

TEST_CASE("exact-2.5d: the set is that of the brute-force oracle", "[methods][oracle]")
{
  Verdicts met;
  for (auto const kind : height_scenes)
    for (int trial = 0; trial < trials(40); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(1000 * int(kind) + trial));
      compare(height_case(random, kind, random.between(3, 12)), met);
    }
  CAPTURE(met.visible, met.hidden, met.undecided);
  CHECK(met.visible > trials(100));
  CHECK(met.hidden > trials(100));
  CHECK(met.undecided <= trials(10));
}

TEST_CASE("exact-2.5d: so is the set of a cell over roofs, of which some lie inside others", "[methods][oracle]")
{
  Verdicts met;
  for (auto const kind : height_scenes)
    for (int trial = 0; trial < trials(40); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(1000 * int(kind) + trial));
      auto c = height_case(random, kind, random.between(8, 16));
      double const unit = kind == HeightScene::far_detail ? 0.001 : 1;
      Point3d const by{random.between(-6, 6) * unit, random.between(-6, 6) * unit, random.between(2, 6) * unit};
      double const size = random.between(1, 5);  // whole objects lie below
      Point3d const c0 = c.cell[0];
      for (auto& p : c.cell) p = {c0.x + size * (p.x - c0.x) + by.x, c0.y + size * (p.y - c0.y) + by.y, p.z + by.z};
      compare(c, met);
    }
  CAPTURE(met.visible, met.hidden, met.undecided);
  CHECK(met.visible > trials(100));
  CHECK(met.hidden > trials(50));
  CHECK(met.undecided <= trials(10));
}
