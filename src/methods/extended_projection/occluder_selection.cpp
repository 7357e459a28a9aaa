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

Box middle_of(ViewCell const& cell)
{
  Point3d const middle = between(cell.bounds().min, cell.bounds().max, 0.5);
  return {middle, middle};
}

}  // namespace

double approximate_pixels(Box const& box, ViewCell const& cell, int resolution)
{
  return importance(box, middle_of(cell)) * (resolution / 3.0) * (resolution / 3.0);
}

bool is_useful(PreparedScene const& scene, ViewCell const& cell, std::uint32_t i)
{
  auto const& occluders = scene.occluders();
  auto const object = occluders.object(i);
  if (!occluders.blocks_from(cell, i, scene.object_bounds()[object])) return false;
  if (!occluders.is_body(i) || scene.bodies().bodies()[occluders.body(i)].kind != ConvexBodies::Kind::triangle)
    return true;
  // Inner bodies come last, and are larger.
  auto const last = occluders.first_of_object()[object + 1] - 1;
  return occluders.is_body(last) || !occluders.blocks_from(cell, last, scene.object_bounds()[object]);
}

std::vector<std::uint32_t> select_occluders(PreparedScene const& scene, ViewCell const& cell, std::size_t count)
{
  auto const& hierarchy = scene.occluder_hierarchy();
  Box const eye = middle_of(cell);
  std::vector<std::uint32_t> out;
  std::priority_queue<Entry> queue;
  queue.push({HUGE_VAL, 0, false});
  while (!queue.empty() && out.size() < count) {
    Entry const top = queue.top();
    queue.pop();
    if (top.is_item) {
      if (is_useful(scene, cell, top.index)) out.push_back(top.index);
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
