#include "support/height_field_oracle.hpp"

#include "support/height_field_search.hpp"

namespace visibility::oracle {

Answer visible_objects(std::span<Column const> columns, std::size_t object_count, Cell const& cell)
{
  validate(columns, object_count, cell);
  Answer answer{std::vector<Verdict>(object_count, Verdict::hidden), std::vector<std::optional<Witness>>(object_count)};
  for (auto const& c : columns)
    if (meets(c, cell)) answer.verdict[c.object] = Verdict::visible;

  detail::Plan const plan(columns, cell);
  detail::Posts posts(plan);
  detail::Search search(plan, posts, [&](Witness const& w) { return confirms(columns, cell, w); });
  for (int i = 0; i < plan.columns; ++i) {
    auto const object = columns[std::size_t(i)].object;
    if (answer.verdict[object] == Verdict::visible) continue;
    auto const result = search(i, object);
    if (result.witness) {
      answer.verdict[object] = Verdict::visible;
      answer.witness[object] = result.witness;
    } else if (!result.decided) {
      answer.verdict[object] = Verdict::undecided;
    }
  }
  return answer;
}

}  // namespace visibility::oracle
