#pragma once

#include "visibility/scene/bounding_hierarchy.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// Some of the objects of a scene, and the nodes of its hierarchy that hold any: for walks that look at these alone.
class ObjectSelection {
public:
  /// Requires: `objects` are items of the hierarchy.
  ObjectSelection(BoundingHierarchy const& hierarchy, std::span<std::uint32_t const> objects)
    : objects_(hierarchy.items().size()), nodes_(hierarchy.nodes().size())
  {
    for (auto const o : objects) objects_[o] = 1;
    for (std::size_t i = nodes_.size(); i-- > 0;) {  // children follow their parent
      auto const& node = hierarchy.nodes()[i];
      if (node.is_leaf())
        for (auto k = node.first; k < node.first + node.count; ++k) nodes_[i] |= objects_[hierarchy.items()[k]];
      else
        nodes_[i] = nodes_[node.first] | nodes_[node.first + 1];
    }
  }

  bool holds(std::uint32_t object) const { return objects_[object] != 0; }
  bool any_below(std::uint32_t node) const { return nodes_[node] != 0; }

private:
  std::vector<std::uint8_t> objects_, nodes_;
};

}  // namespace visibility
