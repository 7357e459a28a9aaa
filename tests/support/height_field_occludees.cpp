#include "support/height_field_polygon.hpp"
#include "support/height_field_search.hpp"

#include <algorithm>

namespace visibility::oracle {
namespace {

/// Whether one polygon is seen.
detail::Search::Result look_for(detail::Polygon const& target, std::uint32_t number, std::span<Column const> columns,
                                Occludee const& occludee, Cell const& cell)
{
  detail::Plan const plan(columns, cell, target);
  detail::Posts posts(plan);
  detail::Search search(plan, posts, [&](Witness const& w) { return confirms(columns, occludee, cell, w); });
  return search(plan.target(), number);
}

}  // namespace

Answer visible_occludees(std::span<Column const> columns, std::span<Occludee const> occludees, Cell const& cell)
{
  std::size_t objects = 0;
  for (auto const& c : columns) objects = std::max(objects, std::size_t(c.object) + 1);
  validate(columns, objects, cell);
  for (auto const& o : occludees) validate(o);

  Answer answer{std::vector<Verdict>(occludees.size(), Verdict::hidden),
                std::vector<std::optional<Witness>>(occludees.size())};
  for (std::size_t i = 0; i < occludees.size(); ++i) {
    auto const& occludee = occludees[i];
    auto& verdict = answer.verdict[i];
    if (meets(occludee, cell)) {
      verdict = Verdict::visible;
      continue;
    }
    for (auto const& polygon : occludee.polygons) {
      if (!detail::has_area(polygon)) continue;
      for (auto const& target : detail::targets(polygon)) {
        if (verdict == Verdict::visible) break;
        auto const result = look_for(target, std::uint32_t(i), columns, occludee, cell);
        if (result.witness) {
          verdict = Verdict::visible;
          answer.witness[i] = result.witness;
        } else if (!result.decided) {
          verdict = Verdict::undecided;
        }
      }
    }
  }
  return answer;
}

}  // namespace visibility::oracle
