#include "support/catch.hpp"
#include "support/height_field_scenes.hpp"

#include "verdicts.hpp"

#include "visibility/evidence/witness.hpp"
#include "visibility/scene/prepared_scene.hpp"

#include <algorithm>
#include <set>

using namespace visibility;
using namespace visibility::hard_cases;

namespace {

std::uint32_t index_of(Scene const& scene, std::string const& name)
{
  auto const at = std::ranges::find(scene.objects, name, &Object::name);
  REQUIRE(at != scene.objects.end());
  return static_cast<std::uint32_t>(at - scene.objects.begin());
}

/// The truth against the brute-force oracle, which knows box cells and columns with width that stay below the cell's
/// top. Returns how many objects it has decided.
int check_with_oracle(HardCase const& c)
{
  if (!c.is_height_field || !c.cell.is_box()) return 0;
  HeightField const field(c.scene);
  auto const columns = test::oracle_columns(field);
  if (columns.size() != field.columns().size() || columns.size() > 60) return 0;
  Box const& b = c.cell.bounds();
  oracle::Answer answer;
  try {
    answer = oracle::visible_objects(
      columns, c.scene.objects.size(),
      {{{b.min.x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, b.max.y}, {b.min.x, b.max.y}}, b.min.z, b.max.z});
  } catch (std::invalid_argument const&) {
    return 0;
  }
  int decided = 0;
  for (std::size_t i = 0; i < answer.verdict.size(); ++i) {
    if (answer.verdict[i] == oracle::Verdict::undecided) continue;
    ++decided;
    CAPTURE(c.scene.objects[i].name);
    bool const visible = std::ranges::find(c.visible, c.scene.objects[i].name) != c.visible.end();
    CHECK(visible == (answer.verdict[i] == oracle::Verdict::visible));
  }
  return decided;
}

void check_kind(Cases (*kind)())
{
  for (auto const& c : kind()) {
    INFO(c.kind << ": " << c.name << "\n" << c.why);
    for (auto const& name : c.visible) index_of(c.scene, name);
    PreparedScene const prepared(c.scene);
    for (auto const& line : c.sight_lines)
      CHECK(confirm(prepared, c.cell, {index_of(c.scene, line.object), line.from, line.to}));
    for (auto const& v : verdicts(c)) {
      CAPTURE(v.method, v.arithmetic, v.missing, v.extra);
      switch (v.guarantee) {
      case Guarantee::exact: CHECK(v.is_right()); break;
      case Guarantee::conservative: CHECK(v.missing.empty()); break;
      case Guarantee::aggressive: CHECK(v.extra.empty()); break;
      case Guarantee::none: break;  // docs/hard-cases.md counts what it gets wrong
      }
      if (v.method == "exact-2.5d" && v.arithmetic != "double") CHECK(v.guarantee == Guarantee::exact);
    }
  }
}

}  // namespace

TEST_CASE("hard cases: grazing", "[hard]") { check_kind(grazing); }
TEST_CASE("hard cases: abutting", "[hard]") { check_kind(abutting); }
TEST_CASE("hard cases: collinear", "[hard]") { check_kind(collinear); }
TEST_CASE("hard cases: coincident", "[hard]") { check_kind(coincident); }
TEST_CASE("hard cases: slits", "[hard]") { check_kind(slits); }
TEST_CASE("hard cases: cyclic", "[hard]") { check_kind(cyclic); }
TEST_CASE("hard cases: far offsets", "[hard]") { check_kind(far_offsets); }
TEST_CASE("hard cases: extreme numbers", "[hard]") { check_kind(extreme); }
TEST_CASE("hard cases: slivers", "[hard]") { check_kind(slivers); }
TEST_CASE("hard cases: equal heights", "[hard]") { check_kind(heights); }
TEST_CASE("hard cases: cells", "[hard]") { check_kind(cells); }
TEST_CASE("hard cases: slanting edges", "[hard]") { check_kind(slanting); }
TEST_CASE("hard cases: closed reguli", "[hard]") { check_kind(reguli); }
TEST_CASE("hard cases: small scenes", "[hard]") { check_kind(small); }

TEST_CASE("hard cases: at least sixty, each with a name of its own", "[hard]")
{
  auto const cases = all();
  std::set<std::string> names;
  for (auto const& c : cases) names.insert(c.kind + c.name);
  CHECK(cases.size() >= 60);
  CHECK(names.size() == cases.size());
}

TEST_CASE("hard cases: the brute-force oracle says the same", "[hard][oracle]")
{
  int decided = 0;
  for (auto const& c : all()) {
    INFO(c.kind << ": " << c.name);
    decided += check_with_oracle(c);
  }
  CHECK(decided > 150);
}

TEST_CASE("hard cases: a scene of nothing is bad input", "[hard]") { CHECK_THROWS_AS(Stage().scene(), BadInput); }
