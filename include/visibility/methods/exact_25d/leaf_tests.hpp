#pragma once

/// What of a search is decided in a leaf of the occlusion tree by signs and wedges.
#include "visibility/methods/exact_25d/search.hpp"

namespace visibility::exact_25d {

/// Whether the cell has points from which the edge is crossed this way, and if that means leaving a column, points
/// above its top: otherwise the sides by which the column is entered hide the edge and what it would hide.
template <Arithmetic A>
bool Search<A>::is_relevant(CrossedEdge const& crossed) const
{
  auto const& e = field_.edges()[crossed.edge];
  Sign const side = crossed.from_left ? Sign::positive : Sign::negative;
  bool const is_crossed = std::ranges::any_of(cell_.corners, [&](Point3d const& c) {
    return orient2d<A>(horizontal(e.a), horizontal(e.b), horizontal(c)) == side;
  });
  auto const& column = field_.columns()[e.column];
  if (!is_crossed || !crossed.from_left || column.is_curtain()) return is_crossed;
  auto const corners = field_.corners(column);
  if (column.is_flat) return cell_.top > corners[0].z;
  return std::ranges::any_of(view_.vertices(), [&](Point3d const& v) {
    return is_positive(orient3d<A>(corners[0], corners[1], corners[2], v));
  });
}

/// Whether an exposed part of the edge lies right under a side of the cell, seen from inside it: then sight lines fall
/// steeply onto it, and nothing is in between. From edge to edge they would be vertical, which no sequence describes.
template <Arithmetic A>
bool Search<A>::is_flush(Target const& target) const
{
  Edge const& edge = target.edge();
  for (std::size_t i = 0; i < cell_.size(); ++i) {
    Edge const side = cell_.exit(i);
    if (plan_order<A>(gate(side), gate(edge)) != PlanOrder::collinear) continue;
    auto const along = along_side(plan_segment(edge), cell_, i);
    if (!along) continue;  // crossed the other way
    if (target.is_fully_exposed() || std::ranges::any_of(target.parts(), [&](auto const& part) {
          return along->low < part.high && along->high > part.low;
        }))
      return true;
  }
  return false;
}

/// Whether lines of the leaf cross the edge beyond the cell.
template <Arithmetic A>
bool Search<A>::is_ahead(Index leaf, Edge const& edge) const
{
  auto const& n = tree_.leaf(leaf);
  return plan_order<A>(gate(cell_.exit(n.exit)), gate(edge)) != PlanOrder::before;
}

/// The edges of the cell's top from which the best sight lines start to a target between these heights: of a flat top
/// the one by which a line leaves if it falls, the one by which it enters if it rises; of any other both, and all inner
/// edges last, in both directions.
template <Arithmetic A>
auto Search<A>::sources(Index leaf, double least_height, double greatest_height) const
  -> boost::container::small_vector<Edge, 2>
{
  auto const& l = tree_.leaf(leaf);
  boost::container::small_vector<Edge, 2> out;
  if (!cell_.flat || least_height < cell_.top) out.push_back(cell_.exit(l.exit));
  if (!cell_.flat || greatest_height >= cell_.top) out.push_back(cell_.entry(l.entry));
  for (auto const& e : cell_.inner) {
    out.push_back(e);
    out.push_back({e.right, e.left});
  }
  return out;
}

template <Arithmetic A>
bool Search<A>::is_hidden_from(Index leaf, Edge const& source, EdgeRange const& s, Edge const& target,
                               EdgeRange const& t, bool as_occluder) const
{
  boost::container::small_vector<PenumbraWedge<A>, 4> wedges;
  for (auto const& f : tree_.leaf(leaf).blockers) {
    if (f.edge == target) {
      if (as_occluder) return true;
      continue;
    }
    if (!f.everywhere) continue;
    auto const order = plan_order<A>(gate(target), gate(f.edge));
    if (order != PlanOrder::before && !(as_occluder && order == PlanOrder::collinear)) continue;
    wedges.emplace_back(source, target, f.edge);
    if (wedges.back().certainly_hides(s, t)) return true;
  }
  return options_.occlusion == Occlusion::exact && !std::same_as<A, Rational> && wedges.size() > 1 &&
         hide_together(wedges, s, t, wedge_depth);
}

/// Whether penumbra wedges hide the target from every source. As an occluder it is then of no use either.
template <Arithmetic A>
bool Search<A>::is_hidden(Index leaf, Funnel const& lines, Edge const& target, EdgeRange const& exposed,
                          bool as_occluder)
{
  if (!options_.penumbra_wedges || tree_.leaf(leaf).blockers.empty()) return false;
  EdgeRange t = crossed_range(lines, gate(target));
  t = {std::max(t.low, exposed.low), std::min(t.high, exposed.high)};
  if (t.low > t.high) return true;
  auto const from = sources(leaf, target);
  std::size_t const outer = from.size() - 2 * cell_.inner.size();
  for (std::size_t i = 0; i < from.size(); ++i) {
    EdgeRange const s = i < outer ? crossed_range(lines, gate(from[i])) : EdgeRange{};
    if (!is_hidden_from(leaf, from[i], s, target, t, as_occluder)) return false;
  }
  return true;
}

/// The same for a part of a seam; by intervals.
template <Arithmetic A>
bool Search<A>::is_hidden(Index leaf, Funnel const& lines, SeamWedge const& part) const
{
  if (std::same_as<A, Rational> || !options_.penumbra_wedges || !cell_.inner.empty()) return false;
  auto const& l = tree_.leaf(leaf);
  auto const is_hidden_from = [&](Edge const& source) {
    EdgeRange const s = crossed_range(lines, gate(source));
    boost::container::small_vector<WedgeVolumes, 4> wedges;
    for (auto const& f : l.blockers) {
      if (!f.everywhere || !part.is_ahead_of(f.edge)) continue;
      wedges.push_back(part.wedge(source, f.edge));
      if (wedges.back().clearly_hides(s, {})) return true;
    }
    return options_.occlusion == Occlusion::exact && wedges.size() > 1 && hide_together(wedges, s, {}, wedge_depth);
  };
  return std::ranges::all_of(sources(leaf, part.least_height(), part.greatest_height()), is_hidden_from);
}

}  // namespace visibility::exact_25d
