#include "visibility/methods/extended_projection/occluder_selection.hpp"

#include <algorithm>
#include <queue>

namespace visibility::extended_projection {

namespace {

struct Entry {
  double importance;
  std::uint32_t index;
  bool is_item;
  bool operator<(Entry const& e) const { return importance < e.importance; }
};

/// Half the surface of a box over the square of its distance; no less for a box around it.
double importance(Box const& b, Box const& eye)
{
  double const x = b.max.x - b.min.x, y = b.max.y - b.min.y, z = b.max.z - b.min.z;
  return (x * y + y * z + z * x) / std::max(approximate_squared_distance(b, eye), 1e-300);
}

}  // namespace

std::vector<std::uint32_t> select_occluders(PreparedScene const& scene, ViewCell const& cell, std::size_t count)
{
  auto const& hierarchy = scene.occluder_hierarchy();
  auto const& occluders = scene.occluders();
  Box const& c = cell.bounds();
  Point3d const middle = between(c.min, c.max, 0.5);
  Box const eye{middle, middle};
  std::vector<std::uint32_t> out;
  std::priority_queue<Entry> queue;
  queue.push({HUGE_VAL, 0, false});
  while (!queue.empty() && out.size() < count) {
    Entry const top = queue.top();
    queue.pop();
    if (top.is_item) {
      if (occluders.blocks_from(cell, top.index, scene.object_bounds()[occluders.object(top.index)]))
        out.push_back(top.index);
      continue;
    }
    auto const& node = hierarchy.nodes()[top.index];
    if (node.is_leaf()) {
      for (auto i = node.first; i < node.first + node.count; ++i)
        queue.push({importance(hierarchy.item_bounds()[i], eye), hierarchy.items()[i], true});
    } else {
      for (auto const child : {node.first, node.first + 1})
        queue.push({importance(hierarchy.nodes()[child].bounds, eye), child, false});
    }
  }
  return out;
}

}  // namespace visibility::extended_projection
