#pragma once

/// How a search tries sight lines in floating point.
#include "visibility/methods/exact_25d/search.hpp"

namespace visibility::exact_25d {

/// Tries sight lines in the middle and near the corners of the polygon of lines, where the clearance is greatest.
template <Arithmetic A>
auto Search<A>::sample(Index leaf, Funnel const& lines, Target const& whole) -> Find
{
  Edge const& target = whole.edge();
  CrossedEdge const& crossed = whole.crossed();
  auto const from = sources(leaf, target);
  std::size_t const outer = from.size() - 2 * cell_.inner.size();
  for (std::size_t k = 0; k < outer; ++k) {
    Edge const source = from[k];
    boost::container::small_vector<PenumbraWedge<A>, 4> wedges;
    for (auto const& f : tree_.leaf(leaf).blockers)
      if (plan_order<A>(gate(target), gate(f.edge)) == PlanOrder::before) wedges.emplace_back(source, target, f.edge);
    for (auto const& [s, t] : sampled_positions(lines, source, target)) {
      if (!whole.may_be_exposed(t)) continue;
      if (std::ranges::any_of(wedges, [s = s, t = t](auto const& w) { return !(w.at(s, t) > 0); })) continue;
      for (double const step : {0x1p-20, 0x1p-30}) {
        Point3d const p = between(between(source.left, source.right, s), near_middle_, step);
        Point3d q = between(target.left, target.right, t);
        q.z -= step * (cell_.top - cell_.bottom);
        q = between(p, q, 1 + 0x1p-20);
        if (!in_interior(view_, p)) continue;
        // The line must reach the edge between its ends, from behind, and below its top.
        if (!is_positive(orient2d<A>(horizontal(p), horizontal(q), horizontal(target.left))) ||
            !is_negative(orient2d<A>(horizontal(p), horizontal(q), horizontal(target.right))) ||
            !is_negative(orient2d<A>(horizontal(target.left), horizontal(target.right), horizontal(p))) ||
            !is_positive(orient2d<A>(horizontal(target.left), horizontal(target.right), horizontal(q))) ||
            !is_negative(orient3d<A>(p, q, target.right, target.left)) || !whole.is_exposed(p, q))
          continue;
        if (options_.occluder_shrink > 0) return simulated(crossed);
        ++counts_.shots;
        auto const blocker = shot_.first_blocker(p, q, crossed);
        if (!blocker) {
          found(crossed, exact(p), options_.witnesses ? whole.crossing(p, q) : exact(p));
          return Find::visible;
        }
        // Otherwise it is too far below the top: closer.
        if (brings_in(leaf, *blocker)) return Find::blocked;
      }
    }
  }
  return Find::nothing;
}

}  // namespace visibility::exact_25d
