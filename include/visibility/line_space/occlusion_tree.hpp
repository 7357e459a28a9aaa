#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/line_space/cell_outline.hpp"
#include "visibility/line_space/line_batch.hpp"
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
    bool everywhere;  ///< crossed beyond the side by which lines enter; otherwise it crosses that side in plan
  };
  struct Leaf {
    Funnel lines;
    boost::container::small_vector<Blocker, 2> blockers;
    std::uint16_t entry = 0, exit = 0;  ///< sides of the outline
  };
  struct Node {
    Point2d point{};   ///< by which an inner node is divided
    double slope = 0;  ///< see `hides`
    double reach = HUGE_VAL;
    Index child = none;  ///< the left child, where the point lies left; the right one follows
    Index parent = none;
    Index leaf = none;  ///< of a leaf, its place among the leaves; a divided leaf leaves it to its left child
    bool is_leaf() const { return child == none; }
  };

  explicit OcclusionTree(CellOutline const& cell) : cell_(cell)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
      for (std::size_t j = 0; j < cell.size(); ++j)
        if (i != j) {
          Leaf root{Funnel::through<A>(gate(cell.entry(i)), gate(cell.exit(j))),
                    {},
                    static_cast<std::uint16_t>(i),
                    static_cast<std::uint16_t>(j)};
          if (root.lines.empty()) continue;
          nodes_.emplace_back().leaf = static_cast<Index>(leaves_.size());
          exits_.push_back(root.exit);
          root_lines_.push_back(root.lines);
          leaves_.push_back(std::move(root));
        }
    roots_ = static_cast<Index>(nodes_.size());
  }

  bool is_leaf(Index node) const { return nodes_[node].is_leaf(); }
  /// Requires: a leaf. The reference stays valid while nodes are divided, but then it is that of the left part.
  Leaf const& leaf(Index node) const { return leaves_[nodes_[node].leaf]; }
  std::deque<Leaf> const& leaves() const { return leaves_; }

  /// Calls visit(leaf, lines) for every leaf with lines that pass between the ends, left end on the left; `lines` are
  /// these lines. `visit` may divide the leaf, and returns true to have its parts visited. Leaves of which the blockers
  /// hide everything as far and as low as `bounds` are left out.
  template <class Visit>
  void visit_leaves(PlanGate const& e, Box const& bounds, Visit&& visit)
  {
    walk(e, bounds, [&](Index leaf, Funnel const& lines) { return visit(leaf, lines) ? Next::again : Next::other; });
  }

  /// Divides the leaf by the point, if it has lines on both sides; the children inherit the blockers.
  /// Returns the part that has the point on `side`, `none` if there is no such line.
  Index divide(Index leaf, Point2d const& point, Sign side);

  void add(Index leaf, Blocker const& blocker)
  {
    leaves_[nodes_[leaf].leaf].blockers.push_back(blocker);
    update(leaf);
  }
  /// Slopes stay as they are until the next `add`: they need what was true, not what is held.
  template <class Predicate>
  void remove_blockers(Index leaf, Predicate&& is_redundant)
  {
    auto& b = leaves_[nodes_[leaf].leaf].blockers;
    b.erase(std::remove_if(b.begin(), b.end(), is_redundant), b.end());
  }

  /// Whether blockers hide everything in the box, in whose place there may be anything. May be false although they do.
  /// Uses in each node the greatest slope up to which all lines are blocked: beyond `reach`, a point whose distance
  /// from the centre of the cell is between d and D is hidden unless it is higher than top + slope * (d + radius), with
  /// D for d if the slope is negative. Where that does not suffice in a leaf, hides_in(leaf, lines, screen) is asked:
  /// whether all sight lines of the leaf to the edge `screen` are blocked before it. It is a side of the box by which
  /// lines enter, so high that none that ends in the box passes above it.
  /// `open` is a leaf to look at first, `none` or any node; if the answer is false, it becomes one that does not hide
  /// it.
  template <class HidesIn>
  bool hides(Box const& box, Index& open, HidesIn&& hides_in) const;

  /// Those of the lines that pass between the ends, left end on the left.
  static Funnel crossing(Funnel const& lines, PlanGate const& e)
  {
    Funnel const part = lines.with<A>(e.left, Sign::positive);
    return part.empty() ? part : part.with<A>(e.right, Sign::negative);
  }

private:
  enum class Next { other, again, stop };
  template <class Visit>
  void walk(PlanGate const& e, Box const& bounds, Visit&& visit) const;

  struct Reach {
    double least, greatest;  // distance from the centre
    double height;           // at most
  };

  Reach reach_of(Box const& box) const
  {
    double const dx = std::max(0.0, std::max(box.min.x - cell_.centre.x, cell_.centre.x - box.max.x));
    double const dy = std::max(0.0, std::max(box.min.y - cell_.centre.y, cell_.centre.y - box.max.y));
    double const fx = std::max(std::fabs(box.min.x - cell_.centre.x), std::fabs(box.max.x - cell_.centre.x));
    double const fy = std::max(std::fabs(box.min.y - cell_.centre.y), std::fabs(box.max.y - cell_.centre.y));
    return {std::sqrt(dx * dx + dy * dy) * (1 - 0x1p-48), std::sqrt(fx * fx + fy * fy) * (1 + 0x1p-48), box.max.z};
  }
  /// `Rational` asks leaves instead: it is what the filtered arithmetic is compared with.
  bool is_below_slope(Node const& n, Reach const& r) const
  {
    if (std::same_as<A, Rational> || r.least < n.reach) return false;
    double const rise = n.slope * ((n.slope > 0 ? r.least : r.greatest) + cell_.radius);
    return r.height <= cell_.top + rise - 0x1p-48 * (std::fabs(cell_.top) + std::fabs(rise));
  }
  bool is_behind(std::size_t exit, Box const& box, Sign side = Sign::negative) const;
  bool is_apart(Box const& box) const;
  double screen_height(Box const& box) const;
  struct Slope {
    double slope, reach;
  };
  Slope slope_over(Funnel const& lines, Blocker const& blocker) const;
  void update(Index leaf);

  CellOutline const& cell_;
  std::vector<Node> nodes_;           // small, for the way down
  std::deque<Leaf> leaves_;           // references stay valid
  std::vector<std::uint16_t> exits_;  // of the roots
  std::vector<Funnel> root_lines_;
  Index roots_ = 0;
};

template <Arithmetic A>
auto OcclusionTree<A>::divide(Index node, Point2d const& point, Sign side) -> Index
{
  Leaf& whole = leaves_[nodes_[node].leaf];
  auto const sides = whole.lines.template sides_of<A>(point);
  Funnel left = whole.lines.template with<A>(point, Sign::positive, sides);
  Funnel right = whole.lines.template with<A>(point, Sign::negative, sides);
  if (left.empty() || right.empty()) return (side == Sign::positive ? left : right).empty() ? none : node;
  auto const child = static_cast<Index>(nodes_.size());
  Node part = nodes_[node];
  part.parent = node;
  nodes_.push_back(part);
  part.leaf = static_cast<Index>(leaves_.size());
  nodes_.push_back(part);
  leaves_.push_back({std::move(right), whole.blockers, whole.entry, whole.exit});
  whole.lines = std::move(left);
  nodes_[node].point = point;
  nodes_[node].child = child;
  // The parts are smaller: their slopes may be steeper.
  update(child);
  update(child + 1);
  return side == Sign::positive ? child : child + 1;
}

/// The lowest sight line over a blocker at distance F and height h reaches, at distance d, the height
///   top + (h - top) (d + radius) / (F + radius)  if it rises, from the far side of the cell, and at least
///   top + (h - top) (d + radius) / (F - radius)  if it falls, from the near side.
/// proofs/exact_2_5d.md.
template <Arithmetic A>
auto OcclusionTree<A>::slope_over(Funnel const& lines, Blocker const& b) const -> Slope
{
  EdgeRange const r = crossed_range(lines, gate(b.edge));
  auto const at = [](double l, double h, double t) { return l + t * (h - l); };
  double const x0 = at(b.edge.left.x, b.edge.right.x, r.low) - cell_.centre.x;
  double const y0 = at(b.edge.left.y, b.edge.right.y, r.low) - cell_.centre.y;
  double const x1 = at(b.edge.left.x, b.edge.right.x, r.high) - cell_.centre.x;
  double const y1 = at(b.edge.left.y, b.edge.right.y, r.high) - cell_.centre.y;
  auto const size = [](double u, double v) { return std::fabs(u) + std::fabs(v); };
  double const scale =
    size(b.edge.left.x, b.edge.right.x) + size(b.edge.left.y, b.edge.right.y) + size(cell_.centre.x, cell_.centre.y);
  double const room = 0x1p-48 * scale;
  double const far = std::sqrt(std::max(x0 * x0 + y0 * y0, x1 * x1 + y1 * y1)) * (1 + 0x1p-50) + room;
  double const low = std::min(at(b.edge.left.z, b.edge.right.z, r.low), at(b.edge.left.z, b.edge.right.z, r.high)) -
                     0x1p-48 * size(b.edge.left.z, b.edge.right.z);
  double const rise = low - cell_.top - 0x1p-50 * size(low, cell_.top);
  Slope out{-HUGE_VAL, std::max(far, cell_.radius)};
  if (rise > 0) {
    out.slope = rise / (far + cell_.radius) * (1 - 0x1p-48);
  } else {
    // The point of the crossed part that is nearest to the centre.
    double const dx = x1 - x0, dy = y1 - y0, length = dx * dx + dy * dy;
    double const t = length > 0 ? std::clamp(-(x0 * dx + y0 * dy) / length, 0.0, 1.0) : 0;
    double const near = std::hypot(x0 + t * dx, y0 + t * dy) * (1 - 0x1p-40) - room - cell_.radius;
    if (near > 0) out.slope = rise / near * (1 + 0x1p-48);
  }
  return out;
}

/// Computes the slope of a leaf and passes it on to the nodes above.
template <Arithmetic A>
void OcclusionTree<A>::update(Index node)
{
  Node& n = nodes_[node];
  Leaf const& l = leaf(node);
  n.slope = -HUGE_VAL;
  n.reach = HUGE_VAL;
  for (auto const& b : l.blockers) {
    if (!b.everywhere) continue;
    Slope const s = slope_over(l.lines, b);
    if (s.slope > n.slope) {
      n.slope = s.slope;
      n.reach = s.reach;
    }
  }
  for (Index i = n.parent; i != none; i = nodes_[i].parent) {
    Node& p = nodes_[i];
    Node const &left = nodes_[p.child], &right = nodes_[p.child + 1];
    double const slope = std::min(left.slope, right.slope), reach = std::max(left.reach, right.reach);
    if (p.slope == slope && p.reach == reach) break;
    p.slope = slope;
    p.reach = reach;
  }
}

template <Arithmetic A>
template <class Visit>
void OcclusionTree<A>::walk(PlanGate const& e, Box const& bounds, Visit&& visit) const
{
  // The lines of a part include those that cross e in the node, and others where a divided part was not cut because the
  // other side is hidden.
  struct Part {
    Index node;
    bool is_exact;
    Funnel lines;
  };
  Reach const reach = reach_of(bounds);
  boost::container::small_vector<Part, 8> stack;
  for (Index r = 0; r < roots_; ++r) {
    if (is_below_slope(nodes_[r], reach) || is_behind(exits_[r], bounds)) continue;
    Funnel lines = crossing(root_lines_[r], e);
    if (!lines.empty()) stack.push_back({r, true, std::move(lines)});
  }
  while (!stack.empty()) {
    Part part = std::move(stack.back());
    stack.pop_back();
    LineBatch<A> const batch(part.lines, cell_.centre);
    for (;;) {
      if (nodes_[part.node].is_leaf()) {
        if (!part.is_exact) part.lines = crossing(leaf(part.node).lines, e);
        if (part.lines.empty()) break;
        part.is_exact = true;
        switch (visit(part.node, std::as_const(part.lines))) {
        case Next::again:
          if (!is_below_slope(nodes_[part.node], reach)) stack.push_back(std::move(part));
          break;
        case Next::other: break;
        case Next::stop: return;
        }
        break;
      }
      Node const& n = nodes_[part.node];
      bool const left_open = !is_below_slope(nodes_[n.child], reach);
      bool const right_open = !is_below_slope(nodes_[n.child + 1], reach);
      if (!left_open && !right_open) break;
      using Answer = typename LineBatch<A>::Answer;
      std::array<double, LineBatch<A>::capacity> values;
      Answer answer = batch.side(n.point, values);
      typename Funnel::Sides sides;
      if (answer == Answer::both && left_open && right_open) {
        for (std::size_t i = 0; i < part.lines.vertices().size(); ++i)
          sides.push_back(values[i] > 0 ? Sign::positive : Sign::negative);
      } else if (answer == Answer::unknown) {
        sides = part.lines.template sides_of<A>(n.point);
        bool const left = std::ranges::any_of(sides, [](Sign s) { return is_positive(s); });
        bool const right = std::ranges::any_of(sides, [](Sign s) { return is_negative(s); });
        answer = left && right ? Answer::both : left ? Answer::left : Answer::right;
      }
      if (answer == Answer::both && left_open && right_open) {
        stack.push_back({n.child + 1, part.is_exact, part.lines.template with<A>(n.point, Sign::negative, sides)});
        stack.push_back({n.child, part.is_exact, part.lines.template with<A>(n.point, Sign::positive, sides)});
        break;
      }
      bool const goes_left = answer == Answer::left || (answer == Answer::both && left_open);
      if (!(goes_left ? left_open : right_open)) break;
      part.is_exact &= answer != Answer::both;
      part.node = n.child + (goes_left ? 0 : 1);
    }
  }
}

/// Whether the box certainly lies on one side of the line of a side: behind it lines that leave by it no longer come;
/// ahead of it, on the positive side, is nothing of the outline.
template <Arithmetic A>
bool OcclusionTree<A>::is_behind(std::size_t exit, Box const& box, Sign where) const
{
  auto const side = cell_.exit(exit);
  for (int i = 0; i < 4; ++i) {
    Enclosed const s =
      detail::enclosed_orient2d(horizontal(side.left), horizontal(side.right), horizontal(box.corner(i)));
    if (!(is_negative(where) ? s.value < -s.error : s.value > s.error)) return false;
  }
  return true;
}

/// The height of the highest line of sight into the box where it enters. It rises to the top, or falls to it from the
/// height h of the cell's top: then at most D / (d + D) of its way lies in the box, d the least distance of the cell
/// from the box and D the box's diagonal.
template <Arithmetic A>
double OcclusionTree<A>::screen_height(Box const& box) const
{
  double const fall = cell_.top - box.max.z;
  if (!(fall > 0)) return box.max.z;
  double const diagonal = std::hypot(box.max.x - box.min.x, box.max.y - box.min.y);
  double const distance = std::max(0.0, reach_of(box).least * (1 - 0x1p-48) - cell_.radius * (1 + 0x1p-48));
  if (!(distance + diagonal > 0)) return cell_.top;
  double const height = box.max.z + fall * (diagonal / (distance + diagonal)) * (1 + 0x1p-40) +
                        0x1p-48 * (std::fabs(box.max.z) + std::fabs(cell_.top));
  return std::min(height, cell_.top);
}

/// Whether the box certainly has no point within the outline of the cell.
template <Arithmetic A>
bool OcclusionTree<A>::is_apart(Box const& box) const
{
  for (std::size_t i = 0; i < cell_.size(); ++i)
    if (is_behind(i, box, Sign::positive)) return true;
  auto const beyond = [&](auto const& coordinate) {
    return std::ranges::all_of(cell_.corners, [&](Point3d const& c) { return coordinate(c) < coordinate(box.min); }) ||
           std::ranges::all_of(cell_.corners, [&](Point3d const& c) { return coordinate(c) > coordinate(box.max); });
  };
  return beyond([](Point3d const& p) { return p.x; }) || beyond([](Point3d const& p) { return p.y; });
}

/// Lines come from outside, so they enter the box by a side that has corners of the cell behind it.
template <Arithmetic A>
template <class HidesIn>
bool OcclusionTree<A>::hides(Box const& box, Index& open, HidesIn&& hides_in) const
{
  if (!is_apart(box)) return false;
  double const height = screen_height(box);
  std::array<Point3d, 4> const corners{Point3d{box.min.x, box.min.y, height}, Point3d{box.max.x, box.min.y, height},
                                       Point3d{box.max.x, box.max.y, height}, Point3d{box.min.x, box.max.y, height}};
  std::array const is_crossed{std::ranges::any_of(cell_.corners, [&](Point3d const& c) { return c.y < box.min.y; }),
                              std::ranges::any_of(cell_.corners, [&](Point3d const& c) { return c.x > box.max.x; }),
                              std::ranges::any_of(cell_.corners, [&](Point3d const& c) { return c.y > box.max.y; }),
                              std::ranges::any_of(cell_.corners, [&](Point3d const& c) { return c.x < box.min.x; })};
  auto const screen = [&](std::size_t i) { return PortalSequence::Edge{corners[i], corners[(i + 1) % 4]}; };
  // What is open for a group is likely to be open for its parts.
  if (open != none && nodes_[open].is_leaf() && !is_behind(leaf(open).exit, box) &&
      !is_below_slope(nodes_[open], reach_of(box)))
    for (std::size_t i = 0; i < 4; ++i) {
      if (!is_crossed[i]) continue;
      Funnel const lines = crossing(leaf(open).lines, gate(screen(i)));
      if (!lines.empty() && !hides_in(open, lines, screen(i))) return false;
    }
  open = none;
  for (std::size_t i = 0; i < 4 && open == none; ++i)
    if (is_crossed[i])
      walk(gate(screen(i)), box, [&](Index leaf, Funnel const& lines) {
        if (hides_in(leaf, lines, screen(i))) return Next::other;
        open = leaf;
        return Next::stop;
      });
  return open == none;
}

}  // namespace visibility
