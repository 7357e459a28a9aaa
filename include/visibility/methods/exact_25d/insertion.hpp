#pragma once

/// How a search inserts edges into the occlusion tree.
#include "visibility/methods/exact_25d/search.hpp"

namespace visibility::exact_25d {

template <Arithmetic A>
void Search<A>::insert(CrossedEdge const& crossed)
{
  auto const& e = field_.edges()[crossed.edge];
  Edge const edge = portal(e, crossed.from_left);
  Box const box = bounding_box(e);
  tree_.visit_leaves(gate(edge), box, [&](Index leaf, Funnel const& lines) {
    if (is_ahead(leaf, edge) && !is_hidden(leaf, lines, edge, {}, true)) insert_in_leaf(leaf, edge, lines);
    return false;
  });
}

/// An edge that stops a line goes into the leaf of that line; if it stops another one, wherever it is not hidden. Most
/// never do, and would divide leaves where nobody asks.
template <Arithmetic A>
void Search<A>::insert(Index leaf, CrossedEdge const& crossed)
{
  auto stopped = has_stopped_[2 * crossed.edge + (crossed.from_left ? 1 : 0)];
  if (stopped) return insert(crossed);
  stopped = true;
  Edge const edge = portal(field_, crossed);
  Funnel const lines = tree_.crossing(tree_.leaf(leaf).lines, gate(edge));
  if (!lines.empty() && is_ahead(leaf, edge) && !is_hidden(leaf, lines, edge, {}, true))
    insert_in_leaf(leaf, edge, lines);
}

/// Inserts an edge that stops a line of the leaf, unless the leaf holds it; whether that changed the leaf.
template <Arithmetic A>
bool Search<A>::brings_in(Index leaf, CrossedEdge const& blocker)
{
  Edge const edge = portal(field_, blocker);
  if (holds(leaf, edge)) return false;
  ++counts_.shots_blocked;
  insert(leaf, blocker);
  return !tree_.is_leaf(leaf) || holds(leaf, edge);
}

/// The edge shortened at both ends, rounded; degenerate where nothing is left.
template <Arithmetic A>
auto Search<A>::shrunk(Edge const& edge) const -> Edge
{
  double const length = std::hypot(edge.right.x - edge.left.x, edge.right.y - edge.left.y);
  auto const moved = [&](Point3d const& from, Point3d const& to) {
    double const distance = std::hypot(from.x - cell_.centre.x, from.y - cell_.centre.y);
    double const t = std::min(0.5, options_.occluder_shrink * distance / length);
    return Point3d{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), from.z + t * (to.z - from.z)};
  };
  return {moved(edge.left, edge.right), moved(edge.right, edge.left)};
}

/// Divides the leaf by the ends of the edge and adds the edge where it is crossed. Blockers in front of it that it
/// rises above are redundant for what comes later.
template <Arithmetic A>
void Search<A>::insert_in_leaf(Index leaf, Edge const& whole, Funnel const& lines)
{
  auto const& n = tree_.leaf(leaf);
  if (holds(leaf, whole)) return;
  auto const order = plan_order<A>(gate(cell_.entry(n.entry)), gate(whole));
  if (order == PlanOrder::before || order == PlanOrder::collinear) return;
  Edge const edge = options_.occluder_shrink > 0 ? shrunk(whole) : whole;
  leaf = tree_.divide(leaf, horizontal(edge.left), Sign::positive);
  if (leaf != Tree::none) leaf = tree_.divide(leaf, horizontal(edge.right), Sign::negative);
  if (leaf == Tree::none) return;
  bool const everywhere = order == PlanOrder::after;
  if (everywhere && options_.penumbra_wedges && !keeps_all_ && !tree_.leaf(leaf).blockers.empty() &&
      cell_.inner.empty()) {
    auto const& part = tree_.leaf(leaf);
    EdgeRange const t = crossed_range(lines, gate(edge));
    Edge const entry = cell_.entry(part.entry), exit = cell_.exit(part.exit);
    EdgeRange const s0 = crossed_range(lines, gate(entry)), s1 = crossed_range(lines, gate(exit));
    bool const rises = cell_.flat && std::min(edge.left.z, edge.right.z) > cell_.top;
    tree_.remove_blockers(leaf, [&](typename Tree::Blocker const& f) {
      return f.everywhere && plan_order<A>(gate(edge), gate(f.edge)) == PlanOrder::before &&
             PenumbraWedge<A>(entry, edge, f.edge).certainly_above(s0, t) &&
             (rises || PenumbraWedge<A>(exit, edge, f.edge).certainly_above(s1, t));
    });
  }
  tree_.add(leaf, {edge, everywhere});
  ++counts_.occluders_inserted;
}

}  // namespace visibility::exact_25d
