#pragma once

#include "visibility/methods/strong_occlusion/options.hpp"
#include "visibility/methods/strong_occlusion/remainder.hpp"
#include "visibility/methods/strong_occlusion/verdict.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace visibility::strong_occlusion {

/// Looks for strong occluders of convex targets as seen from one cell. All options give the same answer to "is there
/// one"; which one is found is a choice.
template <Arithmetic A>
class OccluderSearch {
public:
  using Item = Remainder::Item;

  /// Keeps references to all three.
  OccluderSearch(Remainder const& remainder, ViewCell const& cell, Options const& options)
    : remainder_(remainder), options_(options),
      shaft_(cell, options.hull_rays ? Shaft::Rays::hull_edges : Shaft::Rays::all,
             options.shaft ? Shaft::Culling::all_rays : Shaft::Culling::leading_ray),
      hidden_nodes_(remainder.occluders().nodes().size()), hidden_(remainder.occluders().items().size())
  {
    std::ranges::copy_if(cell.vertices(), std::back_inserter(highest_),
                         [&](Point3d const& v) { return v.z == cell.bounds().max.z; });
  }

  /// How far a search goes.
  enum class Effort {
    recent,     ///< the occluders found last: a few, likely ones
    exhaustive  ///< all; nothing found means that there is none
  };

  /// An occluder, as an item of the remainder, that blocks every sight line from the cell to the target, if there is
  /// one. Requires: the target shares no point with the cell.
  std::optional<Item> find(Target const& target, Effort effort = Effort::exhaustive)
  {
    ++counts_.targets;
    shaft_.aim(target);
    if (!options_.leading_ray) return find_by_lists();
    for (std::size_t i = 0; i < recent_count_; ++i)
      if (try_candidate(recent_[i])) return remember_again(i);
    if (effort == Effort::recent) return {};
    shaft_.prepare_culling();
    auto const found = walk(
      target.bounds, [&](Box const& b) { return shaft_.may_block_all(b); }, [&](Item i) { return try_candidate(i); });
    if (found) remember(*found);
    return found;
  }

  /// The same, counted as the rays of a face.
  std::optional<Item> find_for_face(Target const& target)
  {
    auto const before = counts_.rays;
    auto const found = find(target);
    counts_.face_rays += counts_.rays - before;
    return found;
  }

  /// Whether no occluder meets the sight line from the cell to `to`: from the highest vertex of the cell, of several
  /// the one furthest away, because standing back shows more. If one does, it is the first candidate of the next
  /// search. Requires: `to` is not in the cell.
  bool is_free(Point3d const& to)
  {
    auto const distance = [&](Point3d const& v) { return (v.x - to.x) * (v.x - to.x) + (v.y - to.y) * (v.y - to.y); };
    Point3d from = highest_[0];
    for (auto const& v : highest_)
      if (distance(v) > distance(from)) from = v;
    for (std::size_t i = 0; i < recent_count_; ++i)
      if (meets(recent_[i], from, to)) return remember_again(i), false;
    SegmentProbe const probe(from, to);
    auto const found = walk(
      Box{to, to}, [&](Box const& b) { return !probe.certainly_misses(b); },
      [&](Item i) { return meets(i, from, to); });
    if (found) remember(*found);
    return !found;
  }

  /// What has a strong occluder need not be tried as one [CohenOr98, 5, optimization 2].
  void hide_node(std::uint32_t node) { hidden_nodes_[node] = true; }
  void hide(Item occluder) { hidden_[occluder] = true; }
  bool is_hidden_node(std::uint32_t node) const { return hidden_nodes_[node]; }
  bool is_hidden(Item occluder) const { return hidden_[occluder]; }

  Counts const& counts() const { return counts_; }

private:
  /// Which of two boxes comes first on the way from one box to another: along the axis of the longest way, to within
  /// rounding. A choice.
  class Ahead {
  public:
    Ahead(Box const& from, Box const& to)
    {
      double longest = -1;
      for (auto const k : {&Point3d::x, &Point3d::y, &Point3d::z}) {
        double const way = (to.min.*k - from.min.*k) + (to.max.*k - from.max.*k);
        if (std::fabs(way) <= longest) continue;
        longest = std::fabs(way);
        axis_ = k;
        up_ = way > 0;
      }
    }
    bool operator()(Box const& a, Box const& b) const
    {
      return (a.min.*axis_ + a.max.*axis_ <= b.min.*axis_ + b.max.*axis_) == up_;
    }

  private:
    double Point3d::*axis_ = &Point3d::x;
    bool up_ = true;
  };

  static constexpr std::size_t cache_size = 4;

  Occluders const& occluders() const { return remainder_.scene().occluders(); }

  bool blocks_from_cell(std::uint32_t occluder) const
  {
    PreparedScene const& scene = remainder_.scene();
    return occluders().blocks_from(shaft_.cell(), occluder, scene.object_bounds()[occluders().object(occluder)]);
  }

  bool try_candidate(Item i)
  {
    auto const occluder = remainder_.occluder(i);
    return blocks_from_cell(occluder) && blocks_all<A>(occluders(), occluder, shaft_, counts_);
  }

  /// Whether the sight line [from, to) meets the occluder.
  bool meets(Item i, Point3d const& from, Point3d const& to)
  {
    auto const occluder = remainder_.occluder(i);
    if ((options_.skip_hidden && hidden_[i]) || !blocks_from_cell(occluder)) return false;
    ++counts_.rays;
    return occluders().visit(occluder,
                             [&](auto const& shape) { return segment_meets<A, End::excluded>(shape, from, to); });
  }

  Item remember_again(std::size_t position)
  {
    std::rotate(recent_.begin(), recent_.begin() + position, recent_.begin() + position + 1);
    return recent_.front();
  }
  void remember(Item found)
  {
    if (!options_.cache) return;
    recent_count_ = std::min(recent_count_ + 1, cache_size);
    remember_again(recent_count_ - 1);
    recent_.front() = found;
  }

  /// The first occluder for which try_body(item) holds, the half of each node that comes first on the way first; only
  /// boxes that may_hold(box) are looked into.
  template <class MayHold, class TryBody>
  std::optional<Item> walk(Box const& towards, MayHold&& may_hold, TryBody&& try_body)
  {
    Ahead const before(shaft_.cell().bounds(), towards);
    BoundingHierarchy const& tree = remainder_.occluders();
    auto const pass = [&](std::uint32_t node) {
      ++counts_.probes;
      return may_hold(tree.nodes()[node].bounds) && !(options_.skip_hidden && hidden_nodes_[node]);
    };
    std::array<std::uint32_t, BoundingHierarchy::max_depth + 2> stack;
    std::size_t top = 0;
    if (!tree.nodes().empty() && pass(0)) stack[top++] = 0;
    while (top > 0) {
      auto const& node = tree.nodes()[stack[--top]];
      if (node.is_leaf()) {
        counts_.probes += node.count;
        for (auto k = node.first; k < node.first + node.count; ++k)
          if (Item const i = tree.items()[k];
              may_hold(tree.item_bounds()[k]) && !(options_.skip_hidden && hidden_[i]) && try_body(i))
            return i;
        continue;
      }
      bool const left = pass(node.first), right = pass(node.first + 1);
      if (left && right) {
        bool const left_first = before(tree.nodes()[node.first].bounds, tree.nodes()[node.first + 1].bounds);
        stack[top++] = node.first + (left_first ? 1 : 0);
        stack[top++] = node.first + (left_first ? 0 : 1);
      } else if (left || right) {
        stack[top++] = node.first + (left ? 0 : 1);
      }
    }
    return {};
  }

  /// The paper's first algorithm [CohenOr98, 3]: each ray lists the occluders it meets; one on every list is a strong
  /// occluder. Ends when none is left.
  std::optional<Item> find_by_lists()
  {
    BoundingHierarchy const& tree = remainder_.occluders();
    std::vector<Item> common, listed;
    for (auto const& ray : shaft_.rays()) {
      SegmentProbe const probe(ray.from, ray.to);
      listed.clear();
      tree.any_along(probe, [&](Item i) {
        if (meets(i, ray.from, ray.to)) listed.push_back(i);
        return false;
      });
      std::ranges::sort(listed);
      if (&ray == &shaft_.rays().front()) {
        common = listed;
      } else {
        std::vector<Item> both;
        std::ranges::set_intersection(common, listed, std::back_inserter(both));
        common = std::move(both);
      }
      if (common.empty()) return {};
    }
    // The lists of hull rays do not decide for bodies that touch the cell or the target.
    auto const found = std::ranges::find_if(common, [&](Item i) { return try_candidate(i); });
    return found == common.end() ? std::nullopt : std::optional(*found);
  }

  Remainder const& remainder_;
  Options const& options_;
  Shaft shaft_;
  std::vector<bool> hidden_nodes_, hidden_;
  std::vector<Point3d> highest_;  // vertices of the cell
  std::array<Item, cache_size> recent_{};
  std::size_t recent_count_ = 0;
  Counts counts_;
};

}  // namespace visibility::strong_occlusion
