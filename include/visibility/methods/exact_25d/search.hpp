#pragma once

#include "visibility/line_space/occlusion_tree.hpp"
#include "visibility/methods/exact_25d/cell_contacts.hpp"
#include "visibility/methods/exact_25d/counts.hpp"
#include "visibility/methods/exact_25d/options.hpp"
#include "visibility/methods/exact_25d/portal_question.hpp"
#include "visibility/methods/exact_25d/scene_shot.hpp"
#include "visibility/methods/exact_25d/seam_wedge.hpp"
#include "visibility/methods/exact_25d/sight_line.hpp"
#include "visibility/methods/exact_25d/target.hpp"
#include "visibility/scene/seams.hpp"

#include <algorithm>
#include <optional>
#include <queue>
#include <stdexcept>
#include <vector>

namespace visibility::exact_25d {

/// One query. What is hidden is proved by the occlusion tree; what is visible is proved by a sight line that is held
/// against the whole scene. If an edge that the tree does not hold stops that line, it is inserted and the search goes
/// on: the tree is completed where it matters, in whatever order edges arrive. proofs/exact_2_5d.md.
template <Arithmetic A>
class Search {
public:
  Search(HeightField const& field, ViewCell const& view, Options const& options)
    : field_(field), view_(view), options_(options), cell_(view), tree_(cell_),
      contacts_(cell_contacts(field, view, cell_)), shot_(field, view, contacts_.ignored_edges),
      is_visible_(field.scene().objects.size()),
      middle_(middle_of(view)), near_middle_{CGAL::to_double(middle_.x), CGAL::to_double(middle_.y),
                                             CGAL::to_double(middle_.z)}
  {
    for (auto const o : contacts_.visible) is_visible_[o] = true;
  }

  void run()
  {
    traverse();
    if (options_.occlusion == Occlusion::exact) settle_open();
    for (std::size_t i = 0; i < field_.seams().size(); ++i) settle(field_.seams()[i], field_.seam_bounds()[i]);
  }

  std::vector<bool> const& is_visible() const { return is_visible_; }
  CellContacts const& contacts() const { return contacts_; }
  OcclusionTree<A> const& tree() const { return tree_; }
  Counts const& counts() const { return counts_; }
  /// One for each visible object but those that are visible by contact; if `Options::witnesses`.
  std::vector<FoundLine> const& lines() const { return lines_; }

private:
  using Tree = OcclusionTree<A>;
  using Index = typename Tree::Index;
  using Edge = PortalSequence::Edge;
  enum class Find { visible, blocked, nothing };
  static constexpr int wedge_depth = 4;      // a choice
  static constexpr int most_retries = 1000;  // rounding may undo what a new blocker does; exact arithmetic has no need

  void traverse();
  void process(std::uint32_t edge);
  void scan(CrossedEdge const& crossed);
  void settle_open()
  {
    for (std::size_t i = 0; i < open_.size(); ++i)
      if (!is_visible_[field_.object_of(field_.edges()[open_[i].edge])]) settle(open_[i]);
  }
  void settle(CrossedEdge const& crossed);
  void settle(Seam const& seam, Box const& bounds);
  void insert(CrossedEdge const& crossed);
  bool insert_in_leaf(Index leaf, CrossedEdge const& crossed, Edge const& whole, Funnel const& lines);
  Edge shrunk(Edge const& edge) const;

  bool is_relevant(CrossedEdge const& crossed) const;
  bool is_flush(Target const& target) const;
  bool holds(Index leaf, Edge const& edge) const
  {
    return std::ranges::any_of(tree_.leaf(leaf).blockers, [&](auto const& b) { return b.edge == edge; });
  }
  bool is_ahead(Index leaf, Edge const& edge) const;
  boost::container::small_vector<Edge, 2> sources(Index leaf, Edge const& target) const;
  boost::container::small_vector<Edge, 2> all_sources(Index leaf) const;
  bool is_hidden(Index leaf, Funnel const& lines, Edge const& target, EdgeRange const& exposed, bool as_occluder);
  bool is_hidden(Index leaf, Funnel const& lines, SeamWedge const& part) const;
  bool is_hidden_from(Index leaf, Edge const& source, EdgeRange const& s, Edge const& target, EdgeRange const& t,
                      bool as_occluder) const;
  Find sample(Index leaf, Funnel const& lines, Target const& target);
  Find decide(Index leaf, Funnel const& lines, Target const& target);
  Find decide(Index leaf, Funnel const& lines, SeamPart const& part, std::uint32_t column);
  template <class Answer>
  Find ask(PortalQuestion<A> question, Index leaf, Answer const& answer);
  template <class Shoot, class Found>
  Find confirm(Index leaf, Point3q const& start, Point3q const& end, Shoot const& shoot, Found const& found_from);
  bool in_interior(Point3d const& p) const;
  static Point3q middle_of(ViewCell const& view)
  {
    RationalNumber const n(static_cast<double>(view.vertices().size()));
    Point3q sum{0, 0, 0};
    for (auto const& v : view.vertices())
      sum = {sum.x + RationalNumber(v.x), sum.y + RationalNumber(v.y), sum.z + RationalNumber(v.z)};
    return {sum.x / n, sum.y / n, sum.z / n};
  }
  /// In a simulated method what is not hidden is visible.
  Find simulated(CrossedEdge const& crossed)
  {
    found(crossed, middle_, middle_);
    return Find::visible;
  }
  /// What is seen over a crossed edge: the wall below it, or the top before it.
  void found(CrossedEdge const& crossed, Point3q const& from, Point3q const& end)
  {
    auto const column = field_.edges()[crossed.edge].column;
    found(column, crossed.from_left && !field_.columns()[column].is_curtain(), from, end);
  }
  void found(std::uint32_t column, bool sees_top, Point3q const& from, Point3q const& end)
  {
    is_visible_[field_.columns()[column].object] = true;
    if (options_.witnesses) lines_.push_back({from, end, column, sees_top});
  }

  HeightField const& field_;
  ViewCell const& view_;
  Options options_;
  CellOutline cell_;
  Tree tree_;
  CellContacts contacts_;
  SceneShot<A> shot_;
  std::vector<bool> is_visible_;
  std::vector<CrossedEdge> open_;  // neither hidden nor seen when their turn came
  std::vector<FoundLine> lines_;
  Point3q middle_;  // in the interior of the cell
  Point3d near_middle_;
  Counts counts_;
};

/// Nearest groups of edges first.
template <Arithmetic A>
void Search<A>::traverse()
{
  auto const& hierarchy = field_.edge_hierarchy();
  if (hierarchy.nodes().empty()) return;
  struct Entry {
    double distance;
    std::uint32_t node;
    bool operator<(Entry const& o) const { return distance > o.distance; }
  };
  auto const distance = [&](Box const& b) {
    double const dx = std::max(0.0, std::max(b.min.x - cell_.centre.x, cell_.centre.x - b.max.x));
    double const dy = std::max(0.0, std::max(b.min.y - cell_.centre.y, cell_.centre.y - b.max.y));
    return dx * dx + dy * dy;
  };
  std::priority_queue<Entry> queue;
  queue.push({0, 0});
  while (!queue.empty()) {
    auto const& node = hierarchy.nodes()[queue.top().node];
    queue.pop();
    if (options_.hierarchical_culling) {
      ++counts_.nodes_tested;
      if (tree_.hides(node.bounds)) {
        ++counts_.nodes_hidden;
        continue;
      }
    }
    if (!node.is_leaf()) {
      for (std::uint32_t c : {node.first, node.first + 1}) queue.push({distance(hierarchy.nodes()[c].bounds), c});
      continue;
    }
    for (auto i = node.first; i < node.first + node.count; ++i) process(hierarchy.items()[i]);
  }
}

template <Arithmetic A>
void Search<A>::process(std::uint32_t edge)
{
  if (std::ranges::binary_search(contacts_.ignored_edges, edge)) return;
  for (bool const from_left : {false, true})
    if (CrossedEdge const crossed{edge, from_left}; is_relevant(crossed)) scan(crossed);
}

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
    // Both run from left to right; positions of the side's ends on the edge, by the coordinate in which it is longer.
    bool const along_x = std::fabs(edge.right.x - edge.left.x) >= std::fabs(edge.right.y - edge.left.y);
    auto const position = [&](Point3d const& p) {
      RationalNumber const from(along_x ? edge.left.x : edge.left.y), to(along_x ? edge.right.x : edge.right.y);
      return RationalNumber((RationalNumber(along_x ? p.x : p.y) - from) / (to - from));
    };
    RationalNumber const left = position(side.left), right = position(side.right);
    if (!(left < right)) continue;  // crossed the other way
    if (target.is_fully_exposed() ? left < 1 && right > 0 : std::ranges::any_of(target.parts(), [&](auto const& part) {
          return left < part.high && right > part.low;
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

/// The edges of the cell's top from which the best sight lines to a target start: of a flat top the one by which a line
/// leaves if it falls, the one by which it enters if it rises.
template <Arithmetic A>
auto Search<A>::sources(Index leaf, Edge const& target) const -> boost::container::small_vector<Edge, 2>
{
  auto const& n = tree_.leaf(leaf);
  boost::container::small_vector<Edge, 2> out;
  if (!cell_.flat || std::min(target.left.z, target.right.z) < cell_.top) out.push_back(cell_.exit(n.exit));
  if (!cell_.flat || std::max(target.left.z, target.right.z) >= cell_.top) out.push_back(cell_.entry(n.entry));
  for (auto const& e : cell_.inner) {
    out.push_back(e);
    out.push_back({e.right, e.left});
  }
  return out;
}

template <Arithmetic A>
auto Search<A>::all_sources(Index leaf) const -> boost::container::small_vector<Edge, 2>
{
  auto const& l = tree_.leaf(leaf);
  boost::container::small_vector<Edge, 2> out{cell_.exit(l.exit), cell_.entry(l.entry)};
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
  bool const falls = !cell_.flat || part.least_height() < cell_.top;
  bool const rises = !cell_.flat || part.greatest_height() >= cell_.top;
  return (!falls || is_hidden_from(cell_.exit(l.exit))) && (!rises || is_hidden_from(cell_.entry(l.entry)));
}

/// Looks at the edge in every leaf that does not hide it: as a target until its object is known to be visible, and as
/// an occluder.
template <Arithmetic A>
void Search<A>::scan(CrossedEdge const& crossed)
{
  auto const& e = field_.edges()[crossed.edge];
  Edge const edge = portal(e, crossed.from_left);
  Box box;
  box.extend(e.a);
  box.extend(e.b);
  auto const object = field_.object_of(e);
  std::optional<Target> const target(std::in_place, field_, crossed);
  // What is buried in other columns is no use as an occluder: they are in the way already.
  if (target->is_covered()) return;
  if (!is_visible_[object] && is_flush(*target)) is_visible_[object] = true;
  bool is_open = false;
  int retries = 0;
  tree_.visit_leaves(gate(edge), box, [&](Index leaf, Funnel const& lines) {
    if (!is_ahead(leaf, edge)) return false;
    ++counts_.portal_tests;
    bool const is_target = !is_visible_[object];
    if (is_hidden(leaf, lines, edge, {}, true)) {
      ++counts_.wedge_hidden;
      // What an edge of equal height in the same place hides as an occluder may still be seen.
      if (is_target && !is_hidden(leaf, lines, edge, target->exposed_range(), false))
        is_open |= options_.occlusion == Occlusion::exact || simulated(crossed) != Find::visible;
      return false;
    }
    if (is_target && !is_hidden(leaf, lines, edge, target->exposed_range(), false)) {
      Find const find = options_.occlusion == Occlusion::single_wedges ? simulated(crossed)
                        : options_.sampled_lines                       ? sample(leaf, lines, *target)
                                                                       : Find::nothing;
      if (find == Find::visible) ++counts_.sampled_visible;
      if (find == Find::blocked) return A::is_exact || ++retries < most_retries;
      is_open |= find == Find::nothing;
    }
    insert_in_leaf(leaf, crossed, edge, lines);
    return false;
  });
  if (is_open && !is_visible_[object]) open_.push_back(crossed);
}

template <Arithmetic A>
void Search<A>::insert(CrossedEdge const& crossed)
{
  auto const& e = field_.edges()[crossed.edge];
  Edge const edge = portal(e, crossed.from_left);
  Box box;
  box.extend(e.a);
  box.extend(e.b);
  tree_.visit_leaves(gate(edge), box, [&](Index leaf, Funnel const& lines) {
    if (is_ahead(leaf, edge) && !is_hidden(leaf, lines, edge, {}, true)) insert_in_leaf(leaf, crossed, edge, lines);
    return false;
  });
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
bool Search<A>::insert_in_leaf(Index leaf, CrossedEdge const& crossed, Edge const& whole, Funnel const& lines)
{
  auto const& n = tree_.leaf(leaf);
  if (holds(leaf, whole)) return false;
  auto const order = plan_order<A>(gate(cell_.entry(n.entry)), gate(whole));
  if (order == PlanOrder::before || order == PlanOrder::collinear) return false;
  Edge const edge = options_.occluder_shrink > 0 ? shrunk(whole) : whole;
  leaf = tree_.divide(leaf, horizontal(edge.left), Sign::positive);
  if (leaf != Tree::none) leaf = tree_.divide(leaf, horizontal(edge.right), Sign::negative);
  if (leaf == Tree::none) return false;
  bool const everywhere = order == PlanOrder::after;
  if (everywhere && options_.penumbra_wedges && !tree_.leaf(leaf).blockers.empty() && cell_.inner.empty()) {
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
  tree_.add(leaf, {edge, crossed.edge, everywhere});
  ++counts_.occluders_inserted;
  return true;
}

template <Arithmetic A>
bool Search<A>::in_interior(Point3d const& p) const
{
  if (view_.is_box()) {
    auto const& b = view_.bounds();
    return b.min.x < p.x && p.x < b.max.x && b.min.y < p.y && p.y < b.max.y && b.min.z < p.z && p.z < b.max.z;
  }
  auto const& shape = view_.shape();
  return std::ranges::all_of(shape.facets, [&](ConvexPolyhedron::Facet const& f) {
    auto const& v = shape.vertices;
    return is_negative(orient3d<A>(v[f.vertices[0]], v[f.vertices[1]], v[f.vertices[2]], p));
  });
}

/// Tries sight lines in the middle and near the corners of the polygon of lines, where the clearance is greatest.
template <Arithmetic A>
auto Search<A>::sample(Index leaf, Funnel const& lines, Target const& whole) -> Find
{
  Edge const& target = whole.edge();
  CrossedEdge const& crossed = whole.crossed();
  auto const& vertices = lines.vertices();
  std::size_t const n = vertices.size();
  // The lines as homogeneous vectors of equal size, by the sides of the four ends.
  struct Sides {
    double source_left, source_right, target_left, target_right;
  };
  auto const from = sources(leaf, target);
  std::size_t const outer = from.size() - 2 * cell_.inner.size();
  for (std::size_t k = 0; k < outer; ++k) {
    Edge const source = from[k];
    boost::container::small_vector<Sides, 8> sides;
    for (auto const& v : vertices) {
      double const dx = v.q.x - v.p.x, dy = v.q.y - v.p.y, size = std::hypot(dx, dy);
      auto const side = [&](Point3d const& x) { return (dx * (x.y - v.p.y) - dy * (x.x - v.p.x)) / size; };
      sides.push_back({side(source.left), side(source.right), side(target.left), side(target.right)});
    }
    boost::container::small_vector<PenumbraWedge<A>, 4> wedges;
    for (auto const& f : tree_.leaf(leaf).blockers)
      if (plan_order<A>(gate(target), gate(f.edge)) == PlanOrder::before) wedges.emplace_back(source, target, f.edge);
    for (std::size_t j = 0; j <= n; ++j) {
      Sides sum{0, 0, 0, 0};
      for (std::size_t i = 0; i < n; ++i) {
        double const w = (i + 1 == j ? 8.0 : 1.0) + 0.1 * static_cast<double>(i);
        sum = {sum.source_left + w * sides[i].source_left, sum.source_right + w * sides[i].source_right,
               sum.target_left + w * sides[i].target_left, sum.target_right + w * sides[i].target_right};
      }
      double const s = sum.source_left / (sum.source_left - sum.source_right);
      double const t = sum.target_left / (sum.target_left - sum.target_right);
      if (!(s > 0 && s < 1 && whole.may_be_exposed(t))) continue;
      if (std::ranges::any_of(wedges, [&](auto const& w) { return !(w.at(s, t) > 0); })) continue;
      auto const between = [](Point3d const& a, Point3d const& b, double x) {
        return Point3d{a.x + x * (b.x - a.x), a.y + x * (b.y - a.y), a.z + x * (b.z - a.z)};
      };
      for (double const step : {0x1p-20, 0x1p-30}) {
        Point3d const p = between(between(source.left, source.right, s), near_middle_, step);
        Point3d q = between(target.left, target.right, t);
        q.z -= step * (cell_.top - cell_.bottom);
        q = between(p, q, 1 + 0x1p-20);
        if (!in_interior(p)) continue;
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
        Edge const edge = portal(field_, *blocker);
        if (holds(leaf, edge)) continue;  // too far below the top: closer
        ++counts_.shots_blocked;
        insert(*blocker);
        if (!tree_.is_leaf(leaf) || holds(leaf, edge)) return Find::blocked;
      }
    }
  }
  return Find::nothing;
}

/// Decides an edge that wedges and samples left open.
template <Arithmetic A>
void Search<A>::settle(CrossedEdge const& crossed)
{
  Target const target(field_, crossed);
  if (target.is_covered()) return;
  auto const& e = field_.edges()[crossed.edge];
  Box box;
  box.extend(e.a);
  box.extend(e.b);
  auto const object = field_.object_of(e);
  int retries = 0;
  tree_.visit_leaves(gate(target.edge()), box, [&](Index leaf, Funnel const& lines) {
    if (is_visible_[object] || !is_ahead(leaf, target.edge()) ||
        is_hidden(leaf, lines, target.edge(), target.exposed_range(), false))
      return false;
    Find find = options_.sampled_lines ? sample(leaf, lines, target) : Find::nothing;
    if (find == Find::nothing) {
      ++counts_.decisions;
      find = decide(leaf, lines, target);
      if (find == Find::visible) ++counts_.decided_visible;
    }
    return find == Find::blocked && (A::is_exact || ++retries < most_retries);
  });
}

/// Looks for the top of a column in front of one of another object that stands on it, if the object was not seen
/// otherwise. Sight lines that meet a crease leave the column by one of its sides.
template <Arithmetic A>
void Search<A>::settle(Seam const& seam, Box const& bounds)
{
  auto const& column = field_.columns()[seam.column];
  if (is_visible_[column.object] || (options_.hierarchical_culling && tree_.hides(bounds))) return;
  boost::container::small_vector<Edge, 4> gates;
  if (seam.is_crease()) {
    auto const corners = field_.corners(column);
    for (std::size_t i = 0; i < corners.size(); ++i)
      gates.push_back({corners[i + 1 < corners.size() ? i + 1 : 0], corners[i]});
  } else {
    gates.push_back(portal(field_.edges()[seam.edge], seam.from_left));
  }
  int retries = 0;
  for (auto const& part : exposed_parts(field_, seam)) {
    SeamWedge const wedge(part);
    for (auto const& edge : gates)
      tree_.visit_leaves(gate(edge), bounds, [&](Index leaf, Funnel const& lines) {
        if (is_visible_[column.object] || !is_ahead(leaf, edge)) return false;
        ++counts_.portal_tests;
        if (is_hidden(leaf, lines, wedge)) {
          ++counts_.wedge_hidden;
          return false;
        }
        ++counts_.decisions;
        Find const find = options_.occlusion == Occlusion::single_wedges
                            ? (is_visible_[column.object] = true, Find::visible)
                            : decide(leaf, lines, part, seam.column);
        if (find == Find::visible) ++counts_.decided_visible;
        return find == Find::blocked && (A::is_exact || ++retries < most_retries);
      });
  }
}

/// The questions that the exposed parts of a target put in a leaf, one for each source, until one is answered.
template <Arithmetic A>
auto Search<A>::decide(Index leaf, Funnel const& lines, Target const& target) -> Find
{
  for (auto const& source : sources(leaf, target.edge())) {
    PortalQuestion<A> question(lines, source, target.edge());
    auto const answer = [&](Point3q const& start, Point3q const& end) {
      return confirm(
        leaf, start, end,
        [&](Point3q const& p, Point3q const& q) { return shot_.first_blocker(p, q, target.crossed()); },
        [&](Point3q const& p) { found(target.crossed(), p, end); });
    };
    for (auto const& part : target.parts()) {
      if (auto const find = ask(question.within(target.point(part.low), target.point(part.high)), leaf, answer);
          find != Find::nothing)
        return find;
    }
    if (target.is_fully_exposed())
      if (auto const find = ask(question, leaf, answer); find != Find::nothing) return find;
  }
  return Find::nothing;
}

/// The same for a part of a seam, which has constructed ends.
template <Arithmetic A>
auto Search<A>::decide(Index leaf, Funnel const& lines, SeamPart const& part, std::uint32_t column) -> Find
{
  PortalSequence::ConstructedEdge const target{part.left, part.right};
  for (auto const& source : all_sources(leaf)) {
    // From the near side to the far one: a funnel through the sides of the column holds lines of both directions.
    auto const question =
      PortalQuestion<A>(lines, source, target).within(horizontal(part.left), horizontal(part.right));
    auto const find = ask(question, leaf, [&](Point3q const& start, Point3q const& end) {
      return confirm(
        leaf, start, end, [&](Point3q const& p, Point3q const& q) { return shot_.first_blocker_before(p, q, end); },
        [&](Point3q const& p) { found(column, true, p, end); });
    });
    if (find != Find::nothing) return find;
  }
  return Find::nothing;
}

template <Arithmetic A>
template <class Answer>
auto Search<A>::ask(PortalQuestion<A> question, Index leaf, Answer const& answer) -> Find
{
  auto const& l = tree_.leaf(leaf);
  for (auto const& f : l.blockers)
    question.add(f.edge, f.everywhere ? std::nullopt : std::optional(cell_.entry(l.entry)));
  Find find = Find::nothing;
  question.any_line([&](Point3q const& start, Point3q const& end) {
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
  if (!A::is_exact || options_.occluder_shrink > 0) return found_from(start), Find::visible;
  auto const between = [](Point3q const& a, Point3q const& b, RationalNumber const& x) {
    return Point3q{a.x + x * (b.x - a.x), a.y + x * (b.y - a.y), a.z + x * (b.z - a.z)};
  };
  RationalNumber step(0x1p-8);
  for (int i = 0; i < 12; ++i, step = step * step) {
    Point3q const p = between(start, middle_, step);
    Point3q low = end;
    low.z = end.z - step;
    Point3q const q = between(p, low, RationalNumber(1) + step);
    ++counts_.shots;
    auto const blocker = shoot(p, q);
    if (!blocker) return found_from(p), Find::visible;
    Edge const edge = portal(field_, *blocker);
    if (holds(leaf, edge)) continue;
    ++counts_.shots_blocked;
    insert(*blocker);
    if (!tree_.is_leaf(leaf) || holds(leaf, edge)) return Find::blocked;
  }
  throw std::logic_error("a sight line is stopped by an edge that it was found to pass");
}

}  // namespace visibility::exact_25d
