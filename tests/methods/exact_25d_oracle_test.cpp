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

}  // namespace

TEST_CASE("exact-2.5d: the set is that of the brute-force oracle", "[methods][oracle]")
{
  int undecided = 0, visible = 0, hidden = 0;
  for (auto const kind : height_scenes)
    for (int trial = 0; trial < trials(40); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(1000 * int(kind) + trial));
      auto const c = height_case(random, kind, random.between(3, 12));
      HeightField const field(c.scene);
      auto const columns = oracle_columns(field);
      oracle::Answer answer;
      try {
        answer = oracle::visible_objects(columns, c.scene.objects.size(), oracle_cell(c.cell));
      } catch (std::invalid_argument const&) {
        continue;  // a column reaches the cell's top
      }
      auto const set = Exact25d<Filtered>()(field, ViewCell::hull(c.cell));
      auto const is_visible = members(set, c.scene.objects.size());
      if (set.guarantee != Guarantee::exact) continue;
      for (std::size_t o = 0; o < is_visible.size(); ++o) {
        CAPTURE(o);
        switch (answer.verdict[o]) {
        case oracle::Verdict::visible:
          CHECK(is_visible[o]);
          ++visible;
          break;
        case oracle::Verdict::hidden:
          CHECK(!is_visible[o]);
          ++hidden;
          break;
        case oracle::Verdict::undecided: ++undecided; break;
        }
      }
    }
  CAPTURE(visible, hidden, undecided);
  CHECK(visible > trials(100));
  CHECK(hidden > trials(100));
  CHECK(undecided <= trials(10));
}
