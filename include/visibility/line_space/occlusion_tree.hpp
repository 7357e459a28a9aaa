#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/line_space/cell_outline.hpp"
#include "visibility/line_space/penumbra_wedge.hpp"

#include <cstdint>
#include <deque>
#include <vector>

namespace visibility {

/// The occlusion tree: a binary space partition of the 2D lines through a view cell. One root for each pair of sides
/// through which a line enters and leaves the cell's outline; inner nodes are divided by plan points, so that every
/// decision is an orientation of three of them; a leaf holds top edges that all its lines cross beyond the cell.
///
/// A leaf need not hold all such edges, and may hold redundant ones: what the tree says is hidden is hidden, by edges
/// that exist, whatever the order of insertion. Points of division are choices.
/// Source: [BWW01]; [Bittner05, §4]; proofs/exact_2_5d.md.
template <Arithmetic A>
class OcclusionTree {
public:
  using Index = std::uint32_t;
  static constexpr Index none = ~Index{0};

  /// A top edge as its lines cross it.
  struct Blocker {
    PortalSequence::Edge edge;
    std::uint32_t name;
    bool everywhere;  ///< beyond the cell for all lines of the leaf; otherwise it crosses the side by which they enter
  };
  struct Node {
    Funnel lines;
    Index parent = none, child = none;  ///< the left child, where the point lies left; the right one follows
    Point2d point{};                    ///< by which an inner node is divided
    std::uint16_t entry = 0, exit = 0;  ///< sides of the outline
    double slope = 0;                   ///< see `hides`
    double reach = 0;
    boost::container::small_vector<Blocker, 2> blockers;
    bool is_leaf() const { return child == none; }
  };

  explicit OcclusionTree(CellOutline const& cell) : cell_(cell)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
      for (std::size_t j = 0; j < cell.size(); ++j)
        if (i != j) {
          Node root;
          root.lines = Funnel::through<A>(gate(cell.entry(i)), gate(cell.exit(j)));
          root.entry = static_cast<std::uint16_t>(i);
          root.exit = static_cast<std::uint16_t>(j);
          if (!root.lines.empty()) nodes_.push_back(root);
        }
    roots_ = static_cast<Index>(nodes_.size());
  }

  CellOutline const& cell() const { return cell_; }
  Node const& node(Index i) const { return nodes_[i]; }
  std::size_t size() const { return nodes_.size(); }
  std::size_t leaves() const { return (nodes_.size() + roots_) / 2; }
  Index roots() const { return roots_; }

  /// Calls visit(leaf) for every leaf with lines that pass between the ends, left end on the left, and perhaps for
  /// others; `visit` may divide the leaf, and returns true to have its parts visited. Leaves of which the blockers hide
  /// everything as far and as low as `bounds` are left out.
  template <class Visit>
  void visit_leaves(PlanGate const& e, Box const& bounds, Visit&& visit)
  {
    Reach const reach = reach_of(bounds);
    for (Index r = 0; r < roots_; ++r) visit_leaves_below(r, e, reach, visit);
  }
  template <class Visit>
  void visit_leaves_below(Index start, PlanGate const& e, Box const& bounds, Visit&& visit)
  {
    visit_leaves_below(start, e, reach_of(bounds), visit);
  }

  /// Divides the leaf by the point, if it has lines on both sides; the children inherit the blockers.
  /// Returns the part that has the point on `side`, `none` if there is no such line.
  Index divide(Index leaf, Point2d const& point, Sign side);

  void add(Index leaf, Blocker const& blocker)
  {
    nodes_[leaf].blockers.push_back(blocker);
    update(leaf);
  }
  template <class Predicate>
  std::size_t remove_blockers(Index leaf, Predicate&& is_redundant)
  {
    auto& b = nodes_[leaf].blockers;
    auto const rest = std::remove_if(b.begin(), b.end(), is_redundant);
    auto const removed = static_cast<std::size_t>(b.end() - rest);
    b.erase(rest, b.end());
    return removed;
  }

  /// Whether blockers hide everything in the box, in whose place there may be anything. May be false although they do.
  /// Uses in each node the steepest slope up to which all lines are blocked: behind `reach`, a point at distance d from
  /// the centre of the cell is hidden unless it is higher than top + slope * (d + radius).
  bool hides(Box const& box) const;

private:
  struct Reach {
    double distance, height;  // least distance from the centre, greatest height
  };

  Reach reach_of(Box const& box) const
  {
    double const dx = std::max(0.0, std::max(box.min.x - cell_.centre.x, cell_.centre.x - box.max.x));
    double const dy = std::max(0.0, std::max(box.min.y - cell_.centre.y, cell_.centre.y - box.max.y));
    return {std::sqrt(dx * dx + dy * dy) * (1 - 0x1p-48), box.max.z};
  }
  bool is_below_slope(Node const& n, Reach const& r) const
  {
    if (!(n.slope > 0) || r.distance < n.reach) return false;
    double const rise = n.slope * (r.distance + cell_.radius);
    return r.height <= cell_.top + rise - 0x1p-48 * (std::fabs(cell_.top) + rise);
  }
  static bool certainly_misses(Funnel const& lines, Box const& box);
  static bool may_cross(Funnel const& lines, PlanGate const& e);
  bool is_behind(std::size_t exit, Box const& box) const;

  template <class Visit>
  void visit_leaves_below(Index start, PlanGate const& e, Reach const& reach, Visit& visit)
  {
    std::vector<Index>& stack = stack_;
    std::size_t const bottom = stack.size();
    stack.push_back(start);
    while (stack.size() > bottom) {
      Index const i = stack.back();
      stack.pop_back();
      if (is_below_slope(nodes_[i], reach) || !may_cross(nodes_[i].lines, e)) continue;
      if (nodes_[i].is_leaf() && !visit(i)) continue;
      if (nodes_[i].is_leaf()) {
        stack.push_back(i);
        continue;
      }
      stack.push_back(nodes_[i].child + 1);
      stack.push_back(nodes_[i].child);
    }
  }

  void update(Index leaf);

  CellOutline const& cell_;
  std::deque<Node> nodes_;  // references stay valid
  std::vector<Index> stack_;
  Index roots_ = 0;
};

template <Arithmetic A>
auto OcclusionTree<A>::divide(Index leaf, Point2d const& point, Sign side) -> Index
{
  auto const sides = nodes_[leaf].lines.template sides_of<A>(point);
  Funnel left = nodes_[leaf].lines.template with<A>(point, Sign::positive, sides);
  Funnel right = nodes_[leaf].lines.template with<A>(point, Sign::negative, sides);
  if (left.empty() || right.empty()) return (side == Sign::positive ? left : right).empty() ? none : leaf;
  auto const child = static_cast<Index>(nodes_.size());
  for (Funnel* part : {&left, &right}) {
    Node& n = nodes_.emplace_back();
    Node const& parent = nodes_[leaf];
    n.lines = std::move(*part);
    n.parent = leaf;
    n.entry = parent.entry;
    n.exit = parent.exit;
    n.blockers = parent.blockers;
    n.slope = parent.slope;
    n.reach = parent.reach;
  }
  nodes_[leaf].point = point;
  nodes_[leaf].child = child;
  nodes_[leaf].blockers.clear();
  nodes_[leaf].blockers.shrink_to_fit();
  // The parts are smaller: their slopes may be steeper.
  update(child);
  update(child + 1);
  return side == Sign::positive ? child : child + 1;
}

/// Computes the slope of a leaf and passes it on to the nodes above.
template <Arithmetic A>
void OcclusionTree<A>::update(Index leaf)
{
  Node& n = nodes_[leaf];
  n.slope = 0;
  n.reach = std::numeric_limits<double>::infinity();
  for (auto const& b : n.blockers) {
    if (!b.everywhere) continue;
    EdgeRange const r = crossed_range(n.lines, gate(b.edge));
    double far = 0, height = std::numeric_limits<double>::infinity();
    for (double const t : {r.low, r.high}) {
      double const x = b.edge.left.x + t * (b.edge.right.x - b.edge.left.x);
      double const y = b.edge.left.y + t * (b.edge.right.y - b.edge.left.y);
      double const scale =
        std::fabs(b.edge.left.x) + std::fabs(b.edge.right.x) + std::fabs(b.edge.left.y) + std::fabs(b.edge.right.y);
      far = std::max(far, std::hypot(x - cell_.centre.x, y - cell_.centre.y) + 0x1p-48 * scale);
      height = std::min(height, b.edge.left.z + t * (b.edge.right.z - b.edge.left.z) -
                                  0x1p-48 * (std::fabs(b.edge.left.z) + std::fabs(b.edge.right.z)));
    }
    double const slope = (height - cell_.top) / (far + cell_.radius) * (1 - 0x1p-48);
    if (slope > n.slope) {
      n.slope = slope;
      n.reach = std::max(far, cell_.radius) * (1 + 0x1p-48);
    }
  }
  for (Index i = n.parent; i != none; i = nodes_[i].parent) {
    Node& p = nodes_[i];
    Node const &l = nodes_[p.child], &r = nodes_[p.child + 1];
    double const slope = std::min(l.slope, r.slope), reach = std::max(l.reach, r.reach);
    if (p.slope == slope && p.reach == reach) break;
    p.slope = slope;
    p.reach = reach;
  }
}

/// Whether an end certainly lies on the wrong side of all lines.
template <Arithmetic A>
bool OcclusionTree<A>::may_cross(Funnel const& lines, PlanGate const& e)
{
  bool left = false, right = false;
  for (auto const& v : lines.vertices()) {
    if (!left) {
      Enclosed const s = detail::enclosed_orient2d(v.p, v.q, e.left);
      left = !(s.value < -s.error);
    }
    if (!right) {
      Enclosed const s = detail::enclosed_orient2d(v.p, v.q, e.right);
      right = !(s.value > s.error);
    }
    if (left && right) return true;
  }
  return false;
}

/// Whether the box certainly lies on one side of all lines.
template <Arithmetic A>
bool OcclusionTree<A>::certainly_misses(Funnel const& lines, Box const& box)
{
  bool all_left = true, all_right = true;
  for (auto const& v : lines.vertices()) {
    double const dx = v.q.x - v.p.x, dy = v.q.y - v.p.y;
    double const x0 = box.min.x - v.p.x, x1 = box.max.x - v.p.x, y0 = box.min.y - v.p.y, y1 = box.max.y - v.p.y;
    double const least = dx * (dx > 0 ? y0 : y1) - dy * (dy > 0 ? x1 : x0);
    double const greatest = dx * (dx > 0 ? y1 : y0) - dy * (dy > 0 ? x0 : x1);
    double const error = 0x1p-49 * (std::fabs(dx) * std::max(std::fabs(y0), std::fabs(y1)) +
                                    std::fabs(dy) * std::max(std::fabs(x0), std::fabs(x1))) +
                         0x1p-900;
    all_left &= least > error;
    all_right &= greatest < -error;
    if (!all_left && !all_right) return false;
  }
  return true;
}

/// Whether the box certainly lies behind the line of a side, where lines that leave by it no longer come.
template <Arithmetic A>
bool OcclusionTree<A>::is_behind(std::size_t exit, Box const& box) const
{
  auto const side = cell_.exit(exit);
  for (int i = 0; i < 4; ++i) {
    Enclosed const s =
      detail::enclosed_orient2d(horizontal(side.left), horizontal(side.right), horizontal(box.corner(i)));
    if (!(s.value < -s.error)) return false;
  }
  return true;
}

template <Arithmetic A>
bool OcclusionTree<A>::hides(Box const& box) const
{
  Reach const reach = reach_of(box);
  boost::container::small_vector<Index, 128> stack;
  for (Index r = 0; r < roots_; ++r)
    if (!is_behind(nodes_[r].exit, box)) stack.push_back(r);
  while (!stack.empty()) {
    Node const& n = nodes_[stack.back()];
    stack.pop_back();
    if (is_below_slope(n, reach) || certainly_misses(n.lines, box)) continue;
    if (n.is_leaf()) return false;
    stack.push_back(n.child + 1);
    stack.push_back(n.child);
  }
  return true;
}

}  // namespace visibility
