#include "visibility/methods/extended_projection/occluder_selection.hpp"

#include <algorithm>
#include <queue>

namespace visibility::extended_projection {

namespace {

/// Of the convex bodies inside an object the largest so many are projected.
constexpr std::uint32_t most_inner_bodies = 3;

struct Entry {
  enum Kind { node, object, occluder };
  double importance;
  std::uint32_t index;
  Kind kind;
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

bool blocks(PreparedScene const& scene, ViewCell const& cell, std::uint32_t i)
{
  auto const& occluders = scene.occluders();
  return occluders.blocks_from(cell, i, scene.object_bounds()[occluders.object(i)]);
}

IndexRange worthwhile_occluders(PreparedScene const& scene, ViewCell const& cell, std::uint32_t object)
{
  auto const& occluders = scene.occluders();
  auto const first = occluders.first_of_object()[object], last = occluders.first_of_object()[object + 1];
  if (occluders.is_body(last - 1) || !blocks(scene, cell, last - 1)) return {first, last};
  // Inner bodies come last, the larger first.
  auto inner = last - 1;
  while (inner > first && !occluders.is_body(inner - 1)) --inner;
  auto const is_triangle = [&](std::uint32_t i) {
    return scene.bodies().bodies()[occluders.body(i)].kind == ConvexBodies::Kind::triangle;
  };
  bool const is_mesh = inner > first && (is_triangle(first) || is_triangle(inner - 1));
  return {is_mesh ? inner : first, std::min(last, inner + most_inner_bodies)};
}

std::vector<std::uint32_t> select_occluders(PreparedScene const& scene, ViewCell const& cell, std::size_t count,
                                            ObjectSelection const* among)
{
  auto const& hierarchy = scene.object_hierarchy();
  Box const eye = middle_of(cell);
  std::vector<std::uint32_t> out;
  std::priority_queue<Entry> queue;
  queue.push({HUGE_VAL, 0, Entry::node});
  while (!queue.empty() && out.size() < count) {
    Entry const top = queue.top();
    queue.pop();
    switch (top.kind) {
    case Entry::occluder: out.push_back(top.index); break;
    case Entry::object: {
      if (among != nullptr && !among->holds(top.index)) break;
      auto const range = worthwhile_occluders(scene, cell, top.index);
      for (auto i = range.first; i < range.last; ++i)
        if (blocks(scene, cell, i)) queue.push({importance(scene.occluders().bounds()[i], eye), i, Entry::occluder});
      break;
    }
    case Entry::node: {
      if (among != nullptr && !among->any_below(top.index)) break;
      auto const& node = hierarchy.nodes()[top.index];
      if (node.is_leaf()) {
        for (auto i = node.first; i < node.first + node.count; ++i)
          queue.push({importance(hierarchy.item_bounds()[i], eye), hierarchy.items()[i], Entry::object});
      } else {
        for (auto const child : {node.first, node.first + 1})
          queue.push({importance(hierarchy.nodes()[child].bounds, eye), child, Entry::node});
      }
    }
    }
  }
  return out;
}

}  // namespace visibility::extended_projection
