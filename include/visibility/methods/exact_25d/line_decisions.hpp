#pragma once

/// How a search decides by portal sequences.
#include "visibility/methods/exact_25d/search.hpp"

namespace visibility::exact_25d {

/// The questions that the exposed parts of a target put in a leaf, one for each source, until one is answered.
template <Arithmetic A>
auto Search<A>::decide(Index leaf, Funnel const& lines, Target const& target) -> Find
{
  for (auto const& source : sources(leaf, target.edge())) {
    PortalQuestion<A> question(lines, source, target.edge());
    auto const answer = [&](Point3q const& start, Point3q const& end) {
      return confirm(
        leaf, start, end,
        [&](auto const& p, auto const& q, auto const&) { return shot_.first_blocker(p, q, target.crossed()); },
        [&](Point3q const& p) { found(target.crossed(), p, end); });
    };
    for (auto const& part : target.parts()) {
      if (auto const find =
            ask(question.within(target.point(part.low), target.point(part.high)), leaf, target.edge(), answer);
          find != Find::nothing)
        return find;
    }
    if (target.is_fully_exposed())
      if (auto const find = ask(question, leaf, target.edge(), answer); find != Find::nothing) return find;
  }
  return Find::nothing;
}

/// The same for a part of a seam, which has constructed ends; `gate` lies on its line, or beyond.
template <Arithmetic A>
auto Search<A>::decide(Index leaf, Funnel const& lines, SeamPart const& part, std::uint32_t column, Edge const& gate)
  -> Find
{
  PortalSequence::ConstructedEdge const target{part.left, part.right};
  for (auto const& source : sources(leaf, -HUGE_VAL, HUGE_VAL)) {
    // From the near side to the far one: a funnel through the sides of the column holds lines of both directions.
    auto const question =
      PortalQuestion<A>(lines, source, target).within(horizontal(part.left), horizontal(part.right));
    auto const find = ask(question, leaf, gate, [&](Point3q const& start, Point3q const& end) {
      return confirm(
        leaf, start, end,
        [&](auto const& p, auto const& q, auto const& e) { return shot_.first_blocker_before(p, q, e); },
        [&](Point3q const& p) { found(column, true, p, end); });
    });
    if (find != Find::nothing) return find;
  }
  return Find::nothing;
}

template <Arithmetic A>
template <class Answer>
auto Search<A>::ask(PortalQuestion<A> question, Index leaf, Edge const& target, Answer const& answer) -> Find
{
  DecisionClock const clock(options_.decision_seconds);
  Find find = Find::nothing;
  question_in(leaf, std::move(question), target).any_line([&](Point3q const& start, Point3q const& end) {
    find = answer(start, end);
    return find != Find::nothing;
  });
  return find;
}

/// Holds a sight line from edge to edge against the whole scene: as its conditions are open, it may start a little
/// inside the cell and end a little below the target's top.
template <Arithmetic A>
template <class Shoot, class Found>
auto Search<A>::confirm(Index leaf, Point3q const& start, Point3q const& end, Shoot const& shoot,
                        Found const& found_from) -> Find
{
  Point3d const near_end = visibility::detail::rounded(end);
  return confirm(
    leaf,
    [&](RationalNumber const& step) {
      Point3q const p = between(start, middle_, step);
      Point3q low = end;
      low.z = end.z - step;
      return std::pair(p, between(p, low, RationalNumber(1) + step));
    },
    [&](auto const& p, auto const& q) {
      if constexpr (std::same_as<decltype(p), Point3d const&>)
        return shoot(p, q, near_end);
      else
        return shoot(p, q, end);
    },
    [&](Point3q const& p, Point3q const&) { return found_from(p), true; });
}

/// The same for a line that is moved by smaller and smaller steps, until found(p, q) accepts it.
template <Arithmetic A>
template <class LineAt, class Shoot, class Found>
auto Search<A>::confirm(Index leaf, LineAt const& line_at, Shoot const& shoot, Found const& found) -> Find
{
  bool const is_faithful = A::is_exact && options_.occluder_shrink == 0;
  RationalNumber step(0x1p-8);
  for (int i = 0; i < 12; ++i, step = step * step) {
    auto const [p, q] = line_at(step);
    if (!is_faithful) return found(p, q), Find::visible;
    ++counts_.shots;
    // Most lines are stopped, and an edge that stops a rounded one is as good.
    if (i == 0 && !std::same_as<A, Rational>) {
      auto const blocker = shoot(visibility::detail::rounded(p), visibility::detail::rounded(q));
      if (blocker && brings_in(leaf, *blocker)) return Find::blocked;
    }
    auto const blocker = shoot(p, q);
    if (!blocker) {
      if (found(p, q)) return Find::visible;
    } else if (brings_in(leaf, *blocker)) {
      return Find::blocked;
    }
  }
  throw std::logic_error("a sight line is stopped by an edge that it was found to pass");
}

}  // namespace visibility::exact_25d
