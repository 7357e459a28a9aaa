#pragma once

#include "visibility/line_space/cell_outline.hpp"
#include "visibility/line_space/plan_order.hpp"
#include "visibility/line_space/portal_decision.hpp"
#include "visibility/line_space/portal_search.hpp"

#include <boost/container/small_vector.hpp>

#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

namespace visibility::exact_25d {

/// Whether some line of a funnel, from a source to a target, passes above all of some edges that it crosses in between.
/// An edge that crosses the target in plan, or the side by which lines enter the cell, lies between the two only for
/// the lines on one side of the crossing point: such cases are told apart first, then each is a portal sequence.
template <Arithmetic A>
class PortalQuestion {
public:
  using Edge = PortalSequence::Edge;

  PortalQuestion(Funnel const& lines, Edge const& source, Edge const& target) : PortalQuestion(lines, source)
  {
    sequence_.target = target;
  }
  PortalQuestion(Funnel const& lines, Edge const& source, PortalSequence::ConstructedEdge const& target)
    : PortalQuestion(lines, source)
  {
    sequence_.constructed_target = target;
  }

  /// The same with lines that have one point on their left and another on their right.
  PortalQuestion within(Point2q const& left, Point2q const& right) const
  {
    PortalQuestion out = *this;
    out.sequence_.constructed_points.push_back({left, PortalSequence::Side::left});
    out.sequence_.constructed_points.push_back({right, PortalSequence::Side::right});
    return out;
  }

  /// An edge that all lines cross beyond `entry`, if given only where they cross it after that.
  void add(Edge const& edge, std::optional<Edge> const& entry)
  {
    PlanOrder const order = order_at_target(edge);
    if (order == PlanOrder::after || order == PlanOrder::collinear) return;
    Ambiguous a{edge, {}};
    if (order == PlanOrder::crossing) a.conditions.push_back({target_gate(), true});
    if (entry) a.conditions.push_back({exact_gate(*entry), false});
    if (a.conditions.empty())
      sequence_.occluders.push_back(edge);
    else
      ambiguous_.push_back(std::move(a));
  }

  /// Calls accept(start, end) with the ends of such lines on source and target, one for each case that has one, until
  /// it returns true.
  template <class Accept>
  void any_line(Accept const& accept)
  {
    decide(0, 0, accept);
  }

  /// Calls accept(positions on the target that are seen) for each case, until it returns true. Requires: the target is
  /// not constructed.
  template <class Accept>
  void any_target_part(Accept const& accept)
  {
    decide(0, 0, Parts<Accept>{accept});
  }

private:
  /// What is asked for: parts of the target instead of lines.
  template <class Accept>
  struct Parts {
    Accept const& accept;
  };
  using Side = PortalSequence::Side;
  using Number = std::conditional_t<std::same_as<A, Rational>, RationalNumber, ExactNumber>;

  /// An edge that counts for the lines that meet all conditions.
  struct Ambiguous {
    Edge edge;
    struct Condition {
      Gate<RationalNumber> other;
      bool before;  ///< the edge must be crossed before the other, or else after it
    };
    boost::container::small_vector<Condition, 2> conditions;
  };

  PortalQuestion(Funnel const& lines, Edge const& source)
  {
    sequence_.source = source;
    for (auto const& v : lines.vertices()) {
      // A pivot has all vertices on one side or on it.
      auto const sides = lines.template sides_of<A>(v.pivot);
      bool const left = std::ranges::find(sides, Sign::positive) != sides.end();
      sequence_.points.push_back({v.pivot, left ? Side::left : Side::right});
    }
    sequence_.points.push_back({horizontal(source.left), Side::left});
    sequence_.points.push_back({horizontal(source.right), Side::right});
  }

  Gate<RationalNumber> target_gate() const
  {
    auto const& t = sequence_.constructed_target;
    return t ? Gate<RationalNumber>{horizontal(t->left), horizontal(t->right)} : exact_gate(sequence_.target);
  }
  PlanOrder order_at_target(Edge const& edge) const
  {
    auto const& t = sequence_.constructed_target;
    if (!t) return plan_order<A>(gate(sequence_.target), gate(edge));
    if constexpr (std::same_as<A, Rational>)
      return plan_order<Rational>(target_gate(), exact_gate(edge));
    else
      return plan_order<FilteredRational>(
        Gate<EnclosedRational>{{t->left.x, t->left.y}, {t->right.x, t->right.y}},
        Gate<EnclosedRational>{{edge.left.x, edge.left.y}, {edge.right.x, edge.right.y}});
  }

  static constexpr bool is_filtered = A::is_exact && !std::same_as<A, Rational>;
  static constexpr int most_rectangles = 400;  // about what an exact decision costs

  template <class Accept>
  bool decide(std::size_t next, std::size_t condition, Accept const& accept);
  bool exists() const
  {
    if constexpr (is_filtered)
      if (auto const a = PortalSearch(sequence_).run(most_rectangles); a != PortalSearch::Answer::unknown)
        return a == PortalSearch::Answer::line;
    return PortalDecision<Number>(sequence_).exists();
  }
  template <class NT>
  std::optional<typename PortalDecision<NT>::SightLine> find() const;
  template <class NT, class Accept>
  bool answer(Accept const& accept) const;
  template <class NT, class Accept>
  bool answer(Parts<Accept> const& parts) const
  {
    return parts.accept(PortalDecision<NT>(sequence_).target_parts());
  }

  static RationalNumber side(Gate<RationalNumber> const& e, Point2q const& x)
  {
    return visibility::detail::Orient2dFormula{}(e.left.x, e.left.y, e.right.x, e.right.y, x.x, x.y);
  }

  PortalSequence sequence_;
  std::vector<Ambiguous> ambiguous_;
};

/// Decides the cases from the ambiguous edge `next` and its condition on; returns whether a line was accepted.
template <Arithmetic A>
template <class Accept>
bool PortalQuestion<A>::decide(std::size_t next, std::size_t condition, Accept const& accept)
{
  if (next == ambiguous_.size()) {
    if constexpr (!A::is_exact) return answer<double>(accept);
    return answer<Number>(accept);
  }
  auto const& [edge, conditions] = ambiguous_[next];
  auto const& [other, before] = conditions[condition];
  Gate<RationalNumber> const g = exact_gate(edge);
  RationalNumber const at_left = side(other, g.left), at_right = side(other, g.right),
                       t = at_left / (at_left - at_right);
  Point2q const crossing{g.left.x + t * (g.right.x - g.left.x), g.left.y + t * (g.right.y - g.left.y)};
  for (Side const s : {Side::left, Side::right}) {
    // Lines with the crossing on their left cross both edges to the right of it.
    bool const is_before = s == Side::left ? at_right < 0 : at_right > 0;
    sequence_.constructed_points.push_back({crossing, s});
    bool accepted = false;
    // Several edges through one funnel: most combinations of sides have no lines.
    bool const is_empty = ambiguous_.size() > 1 && A::is_exact && !exists();
    if (is_empty)
      accepted = false;
    else if (is_before != before)
      accepted = decide(next + 1, 0, accept);
    else if (condition + 1 < conditions.size())
      accepted = decide(next, condition + 1, accept);
    else {
      sequence_.occluders.push_back(edge);
      accepted = decide(next + 1, 0, accept);
      sequence_.occluders.pop_back();
    }
    sequence_.constructed_points.pop_back();
    if (accepted) return true;
  }
  return false;
}

/// A line of the sequence; `Filtered` tries intervals first.
template <Arithmetic A>
template <class NT>
auto PortalQuestion<A>::find() const -> std::optional<typename PortalDecision<NT>::SightLine>
{
  if constexpr (is_filtered) {
    PortalSearch search(sequence_);
    switch (search.run(most_rectangles)) {
    case PortalSearch::Answer::none: return std::nullopt;
    case PortalSearch::Answer::line: return {{RationalNumber(search.source()), RationalNumber(search.target())}};
    case PortalSearch::Answer::unknown: break;
    }
  }
  return PortalDecision<NT>(sequence_).find();
}

template <Arithmetic A>
template <class NT, class Accept>
bool PortalQuestion<A>::answer(Accept const& accept) const
{
  auto const line = find<NT>();
  if (!line) return false;
  auto const& target = sequence_.constructed_target;
  return accept(between(exact(sequence_.source.left), exact(sequence_.source.right), line->source),
                target ? between(target->left, target->right, line->target)
                       : between(exact(sequence_.target.left), exact(sequence_.target.right), line->target));
}

}  // namespace visibility::exact_25d
