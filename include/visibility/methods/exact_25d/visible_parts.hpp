#pragma once

/// What parts of the top edges a search leaves visible.
#include "visibility/methods/exact_25d/explanation.hpp"
#include "visibility/methods/exact_25d/search.hpp"

namespace visibility::exact_25d {

namespace detail {

/// Disjoint ranges in ascending order; those that touch become one.
inline std::vector<PositionRange> united(std::vector<PositionRange> ranges)
{
  std::ranges::sort(ranges, [](auto const& a, auto const& b) { return is_negative(compare(a.low, b.low)); });
  std::vector<PositionRange> out;
  for (auto& r : ranges) {
    if (out.empty() || is_negative(compare(out.back().high, r.low)))
      out.push_back(std::move(r));
    else if (is_negative(compare(out.back().high, r.high)))
      out.back().high = std::move(r.high);
  }
  return out;
}

inline Position position(RationalNumber const& x) { return {x, 0, 0, 1}; }

template <class NT>
Position position(QuadraticNumber<NT> const& x)
{
  auto const exact_value = [](NT const& n) {
    if constexpr (std::same_as<NT, double> || std::same_as<NT, RationalNumber>)
      return RationalNumber(n);
    else
      return n.operator RationalNumber();
  };
  return {exact_value(x.p), exact_value(x.q), exact_value(x.d), exact_value(x.r)};
}

}  // namespace detail

/// Requires: run() was called on a search that keeps all edges. Then a line that passes above the edges of its
/// leaf passes above all edges of the scene: what a leaf does not hold was hidden by what it holds.
template <Arithmetic A>
std::vector<VisibleEdge> Search<A>::visible_edges()
{
  std::vector<VisibleEdge> out;
  field_.edge_hierarchy().front_to_back(
    view_.bounds(), [&](std::uint32_t, Box const& b) { return !is_culled(b); },
    [&](std::uint32_t edge) {
      if (std::ranges::binary_search(contacts_.ignored_edges, edge)) return;
      for (bool const from_left : {false, true}) {
        CrossedEdge const crossed{edge, from_left};
        if (!is_relevant(crossed)) continue;
        auto parts = visible_parts(crossed);
        auto const& column = field_.columns()[field_.edges()[edge].column];
        if (!parts.empty())
          out.push_back({column.object, portal(field_, crossed), from_left && !column.is_curtain(), std::move(parts)});
      }
    });
  return out;
}

template <Arithmetic A>
std::vector<PositionRange> Search<A>::visible_parts(CrossedEdge const& crossed)
{
  Target const target(field_, crossed);
  if (target.is_covered()) return {};
  Edge const& edge = target.edge();
  std::vector<OpenInterval> exposed = target.parts();
  if (target.is_fully_exposed()) exposed.push_back({0, 1});
  std::vector<PositionRange> out;
  // Seen from right above, over the cell's outline, and from inside along a side of it.
  auto const append_exposed = [&](std::optional<OpenInterval> const& seen) {
    if (!seen) return;
    for (auto const& e : exposed) {
      RationalNumber const low = std::max(e.low, seen->low), high = std::min(e.high, seen->high);
      if (low < high) out.push_back({detail::position(low), detail::position(high)});
    }
  };
  append_exposed(inside(plan_segment(edge), cell_));
  for (std::size_t i = 0; i < cell_.size(); ++i) append_exposed(along_side(plan_segment(edge), cell_, i));
  tree_.visit_leaves(gate(edge), bounding_box(field_.edges()[crossed.edge]), [&](Index leaf, Funnel const& lines) {
    if (!is_ahead(leaf, edge) || is_hidden(leaf, lines, edge, target.exposed_range(), false)) return false;
    for (auto const& source : sources(leaf, edge)) {
      PortalQuestion<A> const question(lines, source, edge);
      auto const append = [&](auto const& parts) {
        for (auto const& i : parts.intervals()) out.push_back({detail::position(i.low), detail::position(i.high)});
        return false;
      };
      for (auto const& part : target.parts())
        question_in(leaf, question.within(target.point(part.low), target.point(part.high)), edge)
          .any_target_part(append);
      if (target.is_fully_exposed()) question_in(leaf, question, edge).any_target_part(append);
    }
    return false;
  });
  return detail::united(std::move(out));
}

}  // namespace visibility::exact_25d
