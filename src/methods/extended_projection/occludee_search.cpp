#include "visibility/methods/extended_projection/occludee_search.hpp"

#include <algorithm>

namespace visibility::extended_projection {

bool OccludeeSearch::hides(Box const& box)
{
  ++counts_.boxes_tested;
  for (auto const& map : maps_) {
    Box const b = map.cell().frame(box);
    if (!(b.min.z > map.cell().near)) continue;
    if (map.hides(b) || (improved_ && map.hides_improved(b))) return true;
  }
  return false;
}

bool OccludeeSearch::hides_object(std::uint32_t object)
{
  if (hides(scene_.object_bounds()[object])) return true;
  auto const parts = scene_.bodies().bounds_of(object);
  return parts.size() > 1 && std::ranges::all_of(parts, [&](Box const& b) { return hides(b); });
}

std::vector<std::uint32_t> OccludeeSearch::visible_objects(std::function<void(std::uint32_t)> const& visible,
                                                           ObjectSelection const* among)
{
  std::vector<std::uint32_t> out;
  scene_.object_hierarchy().front_to_back(
    cell_.bounds(),
    [&](std::uint32_t node, Box const& box) {
      if (among != nullptr && !among->any_below(node)) return false;
      if (meet(box, cell_.bounds()) || !hides(box)) return true;
      ++counts_.groups_hidden;
      return false;
    },
    [&](std::uint32_t object) {
      if ((among != nullptr && !among->holds(object)) || hides_object(object)) return;
      out.push_back(object);
      visible(object);
    });
  std::ranges::sort(out);
  return out;
}

}  // namespace visibility::extended_projection
