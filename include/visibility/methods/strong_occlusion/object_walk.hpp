#pragma once

#include "visibility/methods/strong_occlusion/object_visibility.hpp"

#include <utility>
#include <vector>

namespace visibility::strong_occlusion {

/// Walks the objects of a remainder, the nearer half of each group first, and lists those that may be visible.
///
/// A group is dropped if its box has a strong occluder. Before that is tried, one sight line is cast to the object that
/// the walk would reach first in it: if it is free, neither that object nor any group on the way to it is hidden, and
/// none of them need be tested. Otherwise the groups on the way are tested, the largest first; against the occluders
/// found last only, since most groups have no strong occluder and to make sure of that costs more than dropping the
/// others saves.
template <Arithmetic A>
class ObjectWalk {
public:
  using Item = Remainder::Item;

  /// Keeps references to all four.
  ObjectWalk(OccluderSearch<A>& search, Remainder const& remainder, ViewCell const& cell, Options const& options)
    : search_(search), remainder_(remainder), cell_(cell), options_(options),
      effort_(options.cache ? OccluderSearch<A>::Effort::recent : OccluderSearch<A>::Effort::exhaustive),
      possibly_visible_(search, remainder, cell, options)
  {
  }

  /// The possibly visible objects, in the order of the walk. Marks in the search what is hidden.
  std::vector<Item> run()
  {
    auto const& tree = remainder_.objects();
    tree.front_to_back(
      cell_.bounds(), [&](std::uint32_t node, Box const& bounds) { return enter(node, bounds); },
      [&](Item object) { visit(object); });
    return std::move(visible_);
  }

  std::uint64_t groups_hidden() const { return groups_hidden_; }

private:
  static constexpr Item none = ~Item{0};

  bool enter(std::uint32_t node, Box const& bounds)
  {
    if (!options_.groups || !certainly_disjoint(cell_, bounds)) return true;
    if (options_.visible_first) {
      if (aimed_at_ == none) {
        aimed_at_ = remainder_.objects().nearest_item(node, cell_.bounds());
        aimed_at_is_seen_ = possibly_visible_.is_seen(aimed_at_);
      }
      if (aimed_at_is_seen_) return true;
    }
    if (!search_.find(BoxTarget(bounds).target(), effort_)) return true;
    search_.hide_node(node);
    ++groups_hidden_;
    aimed_at_ = none;
    return false;
  }

  void visit(Item object)
  {
    bool const aimed = object == aimed_at_;
    if (aimed) aimed_at_ = none;
    if (remainder_.is_settled(object)) return;
    bool const seen = aimed ? aimed_at_is_seen_ : options_.visible_first && possibly_visible_.is_seen(object);
    if (seen || possibly_visible_(object)) visible_.push_back(object);
  }

  OccluderSearch<A>& search_;
  Remainder const& remainder_;
  ViewCell const& cell_;
  Options const& options_;
  typename OccluderSearch<A>::Effort effort_;
  ObjectVisibility<A> possibly_visible_;
  std::vector<Item> visible_;
  std::uint64_t groups_hidden_ = 0;
  Item aimed_at_ = none;  // of the groups being entered; the walk comes to it before any other object
  bool aimed_at_is_seen_ = false;
};

}  // namespace visibility::strong_occlusion
