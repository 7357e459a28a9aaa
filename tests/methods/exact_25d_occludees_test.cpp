#include "support/catch.hpp"
#include "support/height_field_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/methods/exact_25d/method.hpp"

#include <numeric>

using namespace visibility;
using namespace visibility::test;

namespace {

using Indices = std::vector<std::uint32_t>;

/// The scene once as what hides, and again as what is looked for.
struct Both {
  explicit Both(Scene const& occluders, Scene const& targets) : field(occluders), prepared(targets), occludees(prepared)
  {
  }
  explicit Both(Scene const& scene) : Both(scene, scene) {}
  HeightField field;
  PreparedScene prepared;
  Occludees occludees;
};

template <Arithmetic A = Filtered>
Indices visible(Both const& both, ViewCell const& cell, exact_25d::Options const& options = {})
{
  auto const set = Exact25d<A>(options)(both.field, both.occludees, cell);
  return set.visible;
}

template <class Law>
void for_cases(int base, Law const& law)
{
  for (auto const kind : height_scenes)
    for (int trial = 0; trial < trials(base); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(90000 + 1000 * int(kind) + trial));
      auto const c = height_case(random, kind, random.between(3, 14));
      law(c, random);
    }
}

}  // namespace

TEST_CASE("exact-2.5d: objects are seen alike as occluders and as occludees", "[methods][law]")
{
  int compared = 0;
  for_cases(40, [&](HeightCase const& c, Random&) {
    Both const both(c.scene);
    auto const cell = ViewCell::hull(c.cell);
    auto const expected = Exact25d<Filtered>()(both.field, cell);
    if (expected.guarantee != Guarantee::exact) return;
    ++compared;
    CHECK(visible(both, cell) == expected.visible);
  });
  CHECK(compared > trials(100));
}
