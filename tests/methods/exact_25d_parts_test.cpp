#include "support/catch.hpp"
#include "support/height_field_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/methods/exact_25d/method.hpp"

#include <set>

using namespace visibility;
using namespace visibility::test;
using exact_25d::Explanation;
using exact_25d::Position;
using exact_25d::VisibleEdge;

namespace {

/// Slanted scenes more often: only there parts end where three edges meet a line.
template <class Law>
void for_cases(int base, Law const& law)
{
  for (auto const kind : height_scenes)
    for (int trial = 0; trial < trials(kind == HeightScene::slanted ? 4 * base : base); ++trial) {
      CAPTURE(int(kind), trial);
      Random random(static_cast<std::uint64_t>(120000 + 1000 * int(kind) + trial));
      law(height_case(random, kind, random.between(2, 10)));
    }
}

Position position(RationalNumber const& t) { return {t, 0, 0, 1}; }

bool contains(std::vector<exact_25d::PositionRange> const& parts, RationalNumber const& t)
{
  return std::ranges::any_of(parts, [&](auto const& p) {
    return !is_positive(compare(p.low, position(t))) && !is_positive(compare(position(t), p.high));
  });
}

double value(Position const& p)
{
  return (CGAL::to_double(p.p) + CGAL::to_double(p.q) * std::sqrt(CGAL::to_double(p.d))) / CGAL::to_double(p.r);
}

/// Positions within the parts, between them, and close to their ends on both sides.
std::vector<RationalNumber> positions_to_try(std::vector<exact_25d::PositionRange> const& parts)
{
  std::set<double> ends{0, 1};
  for (auto const& p : parts) ends.insert({value(p.low), value(p.high)});
  std::vector<RationalNumber> out;
  for (auto i = ends.begin(), j = std::next(i); j != ends.end(); i = j++)
    for (double const t : {0.4123, 0.0011, 0.9987}) {
      double const x = *i + t * (*j - *i);
      if (0 < x && x < 1 && *j - *i > 1e-9) out.emplace_back(x);
    }
  return out;
}

/// The parts of a column's side as sight lines cross it, none if it is not listed.
std::vector<exact_25d::PositionRange> parts_of(Explanation const& e, PortalSequence::Edge const& edge, bool sees_top)
{
  for (auto const& v : e.edges)
    if (v.edge == edge && v.sees_top == sees_top) return v.parts;
  return {};
}

}  // namespace

TEST_CASE("exact-2.5d: the visible parts of top edges are those of the brute-force oracle", "[methods][oracle]")
{
  int seen = 0, hidden = 0, quadratic = 0;
  for_cases(4, [&](HeightCase const& c) {
    HeightField const field(c.scene);
    auto const columns = oracle_columns(field);
    if (columns.size() != field.columns().size()) return;  // a curtain
    auto const cell = oracle_cell(c.cell);
    auto const [set, explanation] = Exact25d<>().explain(field, ViewCell::hull(c.cell));
    if (set.guarantee != Guarantee::exact) return;
    for (auto const& e : field.edges())
      for (bool const from_left : {false, true}) {
        PortalSequence::Edge const edge = from_left ? PortalSequence::Edge{e.b, e.a} : PortalSequence::Edge{e.a, e.b};
        auto const parts = parts_of(explanation, edge, from_left);
        for (auto const& p : parts) quadratic += !is_zero(sign_of(p.low.q)) + !is_zero(sign_of(p.high.q));
        auto const& corners = columns[e.column].corners;
        auto const side = static_cast<std::size_t>(std::ranges::find(corners, e.a) - corners.begin());
        for (auto const& t : positions_to_try(parts)) {
          RationalNumber const from_a = from_left ? RationalNumber(RationalNumber(1) - t) : t;
          CAPTURE(e.column, side, from_left, CGAL::to_double(t));
          oracle::Verdict verdict{};
          try {
            verdict =
              oracle::sees_edge_at(columns, e.column, side,
                                   from_left ? oracle::Crossing::leaving : oracle::Crossing::entering, from_a, cell);
          } catch (std::invalid_argument const&) {
            return;  // a column reaches the cell's top
          }
          (verdict == oracle::Verdict::visible ? seen : hidden) += 1;
          CHECK(contains(parts, t) == (verdict == oracle::Verdict::visible));
        }
      }
  });
  CAPTURE(seen, hidden, quadratic);
  CHECK(seen > trials(100));
  CHECK(hidden > trials(100));
  CHECK(quadratic >= trials(1));
}

TEST_CASE("exact-2.5d: the objects of visible edges are visible, and an explanation changes no verdict",
          "[methods][law]")
{
  for_cases(10, [&](HeightCase const& c) {
    HeightField const field(c.scene);
    auto const cell = ViewCell::hull(c.cell);
    auto const [set, explanation] = Exact25d<>().explain(field, cell);
    CHECK(set.visible == Exact25d<>()(field, cell).visible);
    if (set.guarantee != Guarantee::exact) return;
    for (auto const& e : explanation.edges) CHECK(std::ranges::binary_search(set.visible, e.object));
    auto const rational = Exact25d<Rational>().explain(field, cell).second;
    REQUIRE(rational.edges.size() == explanation.edges.size());
    for (std::size_t i = 0; i < rational.edges.size(); ++i) {
      auto const &a = rational.edges[i], &b = explanation.edges[i];
      CHECK(a.edge == b.edge);
      REQUIRE(a.parts.size() == b.parts.size());
      for (std::size_t k = 0; k < a.parts.size(); ++k) {
        CHECK(is_zero(compare(a.parts[k].low, b.parts[k].low)));
        CHECK(is_zero(compare(a.parts[k].high, b.parts[k].high)));
      }
    }
  });
}
