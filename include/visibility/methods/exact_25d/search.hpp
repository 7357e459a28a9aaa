#pragma once

#include "visibility/line_space/occlusion_tree.hpp"
#include "visibility/methods/exact_25d/cell_contacts.hpp"
#include "visibility/methods/exact_25d/counts.hpp"
#include "visibility/methods/exact_25d/decision_clock.hpp"
#include "visibility/methods/exact_25d/explanation.hpp"
#include "visibility/methods/exact_25d/options.hpp"
#include "visibility/methods/exact_25d/outline_ranges.hpp"
#include "visibility/methods/exact_25d/portal_question.hpp"
#include "visibility/methods/exact_25d/sampled_positions.hpp"
#include "visibility/methods/exact_25d/scene_shot.hpp"
#include "visibility/methods/exact_25d/seam_wedge.hpp"
#include "visibility/methods/exact_25d/sight_line.hpp"
#include "visibility/methods/exact_25d/target.hpp"
#include "visibility/scene/exposed_lines.hpp"
#include "visibility/scene/occludees.hpp"
#include "visibility/scene/seams.hpp"

#include <algorithm>
#include <queue>
#include <span>
#include <stdexcept>
#include <vector>

namespace visibility::exact_25d {

/// One query. What is hidden is proved by the occlusion tree; what is visible is proved by a sight line that is held
/// against the whole scene. If an edge that the tree does not hold stops that line, it is inserted and the search goes
/// on: the tree is completed where it matters, in whatever order edges arrive. proofs/exact_2_5d.md.
template <Arithmetic A>
class Search {
public:
  /// Keeps references. `occludees`: what is looked for; if null, the objects of the height field.
  Search(HeightField const& field, ViewCell const& view, Options const& options, Occludees const* occludees = nullptr)
    : field_(field), view_(view), options_(options), occludees_(occludees), cell_(view), tree_(cell_),
      contacts_(cell_contacts(field, view, cell_)), shot_(field, view, contacts_.ignored_edges),
      is_visible_(field.scene().objects.size()), has_stopped_(2 * field.edges().size()),
      middle_(middle_of(view)), near_middle_{CGAL::to_double(middle_.x), CGAL::to_double(middle_.y),
                                             CGAL::to_double(middle_.z)}
  {
    for (auto const o : contacts_.visible) is_visible_[o] = true;
    if (occludees == nullptr) return;
    is_visible_.assign(is_visible_.size(), true);  // nobody asks
    is_found_.resize(occludees->object_count());
  }

  void run()
  {
    traverse();
    if (occludees_ != nullptr) return look_for_occludees();
    if (options_.occlusion == Occlusion::exact) settle_open();
    settle_seams();
  }

  /// By object of what is looked for.
  std::vector<bool> const& is_visible() const { return occludees_ != nullptr ? is_found_ : is_visible_; }
  CellContacts const& contacts() const { return contacts_; }
  OcclusionTree<A> const& tree() const { return tree_; }
  Counts const& counts() const { return counts_; }
  /// One for each visible object but those that are visible by contact; if `Options::witnesses`.
  std::vector<FoundLine> const& lines() const { return lines_; }
  /// The same of occludees.
  std::vector<Witness> const& occludee_witnesses() const { return occludee_witnesses_; }

  /// To be called before run() if visible_edges() is to be called afterwards: every edge is inserted wherever it is not
  /// hidden, and none is dropped for one behind it, as it is of use in between.
  void keep_all() { keeps_all_ = true; }
  std::vector<VisibleEdge> visible_edges();
  CellOutline const& cell() const { return cell_; }

private:
  using Tree = OcclusionTree<A>;
  using Index = typename Tree::Index;
  using Edge = PortalSequence::Edge;
  enum class Find { visible, blocked, nothing };
  static constexpr int wedge_depth = 4;      // a choice
  static constexpr int most_retries = 1000;  // rounding may undo what a new blocker does; exact arithmetic has no need

  /// Edges are inserted where they stop a line that is tried, and nowhere else: most hide nothing that others do not.
  /// Otherwise, where lines are not tried or not held against the scene, wherever they are not hidden.
  bool is_lazy() const
  {
    return options_.sampled_lines && options_.occlusion == Occlusion::exact && !(options_.occluder_shrink > 0) &&
           !keeps_all_;
  }
  void traverse();
  void process(std::uint32_t edge);
  void scan(CrossedEdge const& crossed);
  void settle_open()
  {
    for (std::size_t i = 0; i < open_.size(); ++i)
      if (!is_visible_[field_.object_of(field_.edges()[open_[i].edge])]) settle(open_[i]);
  }
  /// Nearest groups of seams first; those that the tree hides are dropped.
  void settle_seams()
  {
    Index open = Tree::none;
    field_.seam_hierarchy().front_to_back(
      view_.bounds(),
      [&](std::uint32_t, Box const& b) { return !(options_.hierarchical_culling && is_hidden(b, open)); },
      [&](std::uint32_t i) { settle(field_.seams()[i], field_.seam_bounds()[i]); });
  }
  void settle(CrossedEdge const& crossed);
  void settle(Seam const& seam, Box const& bounds);
  void insert(CrossedEdge const& crossed);
  void insert(Index leaf, CrossedEdge const& crossed);
  bool brings_in(Index leaf, CrossedEdge const& blocker);
  void insert_in_leaf(Index leaf, Edge const& whole, Funnel const& lines);
  Edge shrunk(Edge const& edge) const;

  bool is_relevant(CrossedEdge const& crossed) const;
  bool is_flush(Target const& target) const;
  bool holds(Index leaf, Edge const& edge) const
  {
    return std::ranges::any_of(tree_.leaf(leaf).blockers, [&](auto const& b) { return b.edge == edge; });
  }
  bool is_ahead(Index leaf, Edge const& edge) const;
  boost::container::small_vector<Edge, 2> sources(Index leaf, double least_height, double greatest_height) const;
  boost::container::small_vector<Edge, 2> sources(Index leaf, Edge const& target) const
  {
    auto const [least, greatest] = std::minmax(target.left.z, target.right.z);
    return sources(leaf, least, greatest);
  }
  /// Whether the tree hides all that a box may hold; `open` as in OcclusionTree::hides.
  bool is_hidden(Box const& box, Index& open)
  {
    return tree_.hides(box, open, [&](Index leaf, Funnel const& lines, Edge const& screen) {
      if (std::same_as<A, Rational>) return false;
      return !is_ahead(leaf, screen) || is_hidden(leaf, lines, screen, {}, false);
    });
  }
  bool is_hidden(Index leaf, Funnel const& lines, Edge const& target, EdgeRange const& exposed, bool as_occluder);
  bool is_hidden(Index leaf, Funnel const& lines, SeamWedge const& part) const;
  bool is_hidden_from(Index leaf, Edge const& source, EdgeRange const& s, Edge const& target, EdgeRange const& t,
                      bool as_occluder) const;
  Find sample(Index leaf, Funnel const& lines, Target const& target);
  Find decide(Index leaf, Funnel const& lines, Target const& target);
  Find decide(Index leaf, Funnel const& lines, SeamPart const& part, std::uint32_t column, Edge const& gate);
  std::vector<PositionRange> visible_parts(CrossedEdge const& crossed);
  /// With the edges of the leaf, but for one in the place of the target, which is not before it.
  PortalQuestion<A> question_in(Index leaf, PortalQuestion<A> question, Edge const& target) const
  {
    auto const& l = tree_.leaf(leaf);
    for (auto const& f : l.blockers)
      if (!(f.edge == target)) question.add(f.edge, f.everywhere ? std::nullopt : std::optional(cell_.entry(l.entry)));
    return question;
  }
  template <class Answer>
  Find ask(PortalQuestion<A> question, Index leaf, Edge const& target, Answer const& answer);
  template <class Shoot, class Found>
  Find confirm(Index leaf, Point3q const& start, Point3q const& end, Shoot const& shoot, Found const& found_from);
  template <class LineAt, class Shoot, class Found>
  Find confirm(Index leaf, LineAt const& line_at, Shoot const& shoot, Found const& found);

  void look_for_occludees();
  bool is_culled(Box const& box);
  bool is_over_cell(Box const& box) const;
  bool is_flush(SeamPart const& part) const;
  bool look_at(std::uint32_t piece, std::vector<ExposedLine> const& lines, bool decided);
  Find sample(Index leaf, Funnel const& lines, std::uint32_t piece, ExposedLine const& line, SeamWedge const& wedge,
              Edge const& gate);
  Find decide(Index leaf, Funnel const& lines, std::uint32_t piece, ExposedLine const& line, SeamWedge const& wedge,
              Edge const& gate);
  bool found_occludee(std::uint32_t piece, Point3q const& from, Point3q const& to);

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
  Occludees const* occludees_;
  CellOutline cell_;
  Tree tree_;
  CellContacts contacts_;
  SceneShot<A> shot_;
  std::vector<bool> is_visible_;
  std::vector<CrossedEdge> open_;  // neither hidden nor seen when their turn came
  std::vector<bool> has_stopped_;  // crossed edges that stopped a line that was tried
  std::vector<FoundLine> lines_;
  std::vector<bool> is_found_;  // of occludees
  std::vector<Witness> occludee_witnesses_;
  bool keeps_all_ = false;
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
    Index open;  // a leaf that does not hide the group it is part of
    bool operator<(Entry const& o) const { return distance > o.distance; }
  };
  std::priority_queue<Entry> queue;
  queue.push({0, 0, Tree::none});
  while (!queue.empty()) {
    auto const& node = hierarchy.nodes()[queue.top().node];
    Index open = queue.top().open;
    queue.pop();
    auto const items = std::span(hierarchy.items()).subspan(node.is_leaf() ? node.first : 0, node.count);
    if (node.is_leaf() && is_lazy() &&
        std::ranges::all_of(items, [&](std::uint32_t e) { return is_visible_[field_.object_of(field_.edges()[e])]; }))
      continue;
    if (options_.hierarchical_culling) {
      ++counts_.nodes_tested;
      if (is_hidden(node.bounds, open)) {
        ++counts_.nodes_hidden;
        continue;
      }
    }
    if (!node.is_leaf()) {
      for (std::uint32_t c : {node.first, node.first + 1})
        queue.push({approximate_squared_distance(view_.bounds(), hierarchy.nodes()[c].bounds), c, open});
      continue;
    }
    for (auto const edge : items) process(edge);
  }
}

template <Arithmetic A>
void Search<A>::process(std::uint32_t edge)
{
  if (std::ranges::binary_search(contacts_.ignored_edges, edge)) return;
  for (bool const from_left : {false, true})
    if (CrossedEdge const crossed{edge, from_left}; is_relevant(crossed)) scan(crossed);
}

/// Looks at the edge in every leaf that does not hide it: as a target until its object is known to be visible, and as
/// an occluder unless that waits until it stops a line.
template <Arithmetic A>
void Search<A>::scan(CrossedEdge const& crossed)
{
  auto const& e = field_.edges()[crossed.edge];
  Edge const edge = portal(e, crossed.from_left);
  Box const box = bounding_box(e);
  auto const object = field_.object_of(e);
  // What was seen is asked for no more, and is inserted when it stops a line.
  if (is_lazy() && is_visible_[object]) return;
  Target const target(field_, crossed);
  // What is buried in other columns is no use as an occluder: they are in the way already.
  if (target.is_covered()) return;
  if (!is_visible_[object] && is_flush(target)) is_visible_[object] = true;
  bool is_open = false;
  int retries = 0;
  tree_.visit_leaves(gate(edge), box, [&](Index leaf, Funnel const& lines) {
    if (!is_ahead(leaf, edge)) return false;
    ++counts_.portal_tests;
    bool const is_target = !is_visible_[object];
    if (is_hidden(leaf, lines, edge, {}, true)) {
      ++counts_.wedge_hidden;
      // What an edge of equal height in the same place hides as an occluder may still be seen.
      if (is_target && !is_hidden(leaf, lines, edge, target.exposed_range(), false))
        is_open |= options_.occlusion == Occlusion::exact || simulated(crossed) != Find::visible;
      return false;
    }
    // The same edges as above hide it as a target, unless only part of it is one.
    if (is_target && (target.is_fully_exposed() || !is_hidden(leaf, lines, edge, target.exposed_range(), false))) {
      Find const find = options_.occlusion == Occlusion::single_wedges ? simulated(crossed)
                        : options_.sampled_lines                       ? sample(leaf, lines, target)
                                                                       : Find::nothing;
      if (find == Find::visible) ++counts_.sampled_visible;
      if (find == Find::blocked) return A::is_exact || ++retries < most_retries;
      is_open |= find == Find::nothing;
    }
    if (!is_lazy()) insert_in_leaf(leaf, edge, lines);
    return false;
  });
  if (is_open && !is_visible_[object]) open_.push_back(crossed);
}

/// Decides an edge that wedges and samples left open.
template <Arithmetic A>
void Search<A>::settle(CrossedEdge const& crossed)
{
  Target const target(field_, crossed);
  if (target.is_covered()) return;
  auto const& e = field_.edges()[crossed.edge];
  Box const box = bounding_box(e);
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
  Index open = Tree::none;
  if (is_visible_[column.object] || (options_.hierarchical_culling && is_hidden(bounds, open))) return;
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
                            : decide(leaf, lines, part, seam.column, edge);
        if (find == Find::visible) ++counts_.decided_visible;
        return find == Find::blocked && (A::is_exact || ++retries < most_retries);
      });
  }
}

}  // namespace visibility::exact_25d

// The steps.
#include "visibility/methods/exact_25d/insertion.hpp"
#include "visibility/methods/exact_25d/leaf_tests.hpp"
#include "visibility/methods/exact_25d/line_decisions.hpp"
#include "visibility/methods/exact_25d/line_samples.hpp"
#include "visibility/methods/exact_25d/occludee_search.hpp"
#include "visibility/methods/exact_25d/visible_parts.hpp"
