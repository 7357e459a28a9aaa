#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/scene/segment_probe.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// Bounding volume hierarchy over boxes, for every method: all items along a segment, all items that meet a box, and a
/// front-to-back walk from a region that drops whole subtrees. Culling is conservative: nothing that meets the query
/// is ever skipped. Built once, const afterwards; queries may run in parallel.
class BoundingHierarchy {
public:
  struct Node {
    Box bounds;
    std::uint32_t first;  ///< leaf: first position in `items()`; inner: left child, the right child follows it
    std::uint32_t count;  ///< leaf: number of items; inner: 0
    bool is_leaf() const { return count != 0; }
  };

  /// No path is longer: the builder splits at the median from depth 48 on, once more if the tree is carried further.
  static constexpr int max_depth = 128;

  BoundingHierarchy() = default;
  /// O(n log n), binned surface-area heuristic [Wald 2007]. Items are named by their position in `boxes`.
  explicit BoundingHierarchy(std::span<Box const> boxes);
  /// The same tree carried further, from groups down to items: every node of `groups` keeps its position in `nodes()`,
  /// and holds the items of its groups; nodes below its leaves follow. So what is known of a group holds for the node
  /// of that position here. `boxes` lists the items group by group, those of g at first_of_group[g] up to
  /// first_of_group[g + 1]; the bounds of a group are those of its items. Requires: no group is empty.
  BoundingHierarchy(BoundingHierarchy const& groups, std::span<std::uint32_t const> first_of_group,
                    std::span<Box const> boxes);

  std::span<Node const> nodes() const { return nodes_; }             ///< nodes()[0] is the root; empty for no items
  std::span<std::uint32_t const> items() const { return items_; }    ///< permutation of the items, leaves contiguous
  std::span<Box const> item_bounds() const { return item_bounds_; }  ///< the boxes in the order of `items()`
  void validate(std::span<Box const> boxes) const;  ///< throws std::logic_error naming the broken invariant

  /// Calls visit(item) for every item in a node that the segment may meet, in no order, until visit returns true.
  /// Returns whether it did.
  template <class Visit>
  bool any_along(SegmentProbe const& probe, Visit&& visit) const
  {
    return walk([&](Node const& n) { return !probe.certainly_misses(n.bounds); }, visit);
  }

  /// Calls visit(item) for every item in a node whose bounds meet the box, until visit returns true.
  template <class Visit>
  bool any_meeting(Box const& box, Visit&& visit) const
  {
    return walk([&](Node const& n) { return meet(n.bounds, box); }, visit);
  }

  /// The same for every item whose own bounds meet the box.
  template <class Visit>
  bool any_item_meeting(Box const& box, Visit&& visit) const
  {
    if (nodes_.empty()) return false;
    std::uint32_t stack[max_depth + 2];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      Node const& node = nodes_[stack[--top]];
      if (!node.is_leaf()) {
        if (meet(nodes_[node.first + 1].bounds, box)) stack[top++] = node.first + 1;
        if (meet(nodes_[node.first].bounds, box)) stack[top++] = node.first;
        continue;
      }
      for (auto i = node.first; i < node.first + node.count; ++i)
        if (meet(item_bounds_[i], box) && visit(items_[i])) return true;
    }
    return false;
  }

  /// Whether the left child of an inner node is at most as far from `region` as the right one (rounded distances).
  bool left_is_nearer(Node const& node, Box const& region) const
  {
    return approximate_squared_distance(region, nodes_[node.first].bounds) <=
           approximate_squared_distance(region, nodes_[node.first + 1].bounds);
  }

  /// The item that `front_to_back` would visit first below the node.
  std::uint32_t nearest_item(std::uint32_t node, Box const& region) const
  {
    while (!nodes_[node].is_leaf()) node = nodes_[node].first + (left_is_nearer(nodes_[node], region) ? 0 : 1);
    return items_[nodes_[node].first];
  }

  /// Walks the tree depth first, of two children the one nearer to `region` first. enter(node, box) returns whether to
  /// descend, asked when the node's turn comes; visit(item) is called for the items of entered leaves. The order is
  /// that of rounded distances: good for speed, not to be relied on for correctness.
  template <class Enter, class Visit>
  void front_to_back(Box const& region, Enter&& enter, Visit&& visit) const
  {
    if (nodes_.empty()) return;
    std::uint32_t stack[max_depth + 2];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      std::uint32_t const index = stack[--top];
      Node const& node = nodes_[index];
      if (!enter(index, node.bounds)) continue;
      if (node.is_leaf()) {
        for (auto i = node.first; i < node.first + node.count; ++i) visit(items_[i]);
        continue;
      }
      bool const left_first = left_is_nearer(node, region);
      stack[top++] = node.first + (left_first ? 1 : 0);
      stack[top++] = node.first + (left_first ? 0 : 1);
    }
  }

private:
  template <class Pass, class Visit>
  bool walk(Pass&& pass, Visit&& visit) const
  {
    if (nodes_.empty() || !pass(nodes_[0])) return false;
    std::uint32_t stack[max_depth + 2];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      Node const& node = nodes_[stack[--top]];
      if (node.is_leaf()) {
        for (auto i = node.first; i < node.first + node.count; ++i)
          if (visit(items_[i])) return true;
        continue;
      }
      if (pass(nodes_[node.first + 1])) stack[top++] = node.first + 1;
      if (pass(nodes_[node.first])) stack[top++] = node.first;
    }
    return false;
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
  std::vector<Box> item_bounds_;
};

}  // namespace visibility
