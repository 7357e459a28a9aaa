#include "visibility/methods/extended_projection/occludee_search.hpp"

#include "visibility/methods/extended_projection/boxes_in_frame.hpp"

#include <algorithm>

namespace visibility::extended_projection {

/// `box_in`: the box that is looked for, in a frame.
template <class BoxIn>
bool OccludeeSearch::any_hides(BoxIn&& box_in)
{
  ++counts_.boxes_tested;
  CellViews const* cell = nullptr;  // maps of one direction stand together
  Box b;
  for (auto const& map : maps_) {
    if (&map.cell() != cell) {
      cell = &map.cell();
      b = box_in(cell->frame);
    }
    if (!(b.min.z > map.cell().near)) continue;
    if (map.hides(b) || (improved_ && map.cell().is_box && map.hides_improved(b))) return true;
  }
  return false;
}

bool OccludeeSearch::hides(Box const& box)
{
  return projector_.may_hide(box) && any_hides([&](Frame const& frame) { return frame(box); });
}

bool OccludeeSearch::hides_object(std::uint32_t object)
{
  if (!projector_.may_hide(scene_.object_bounds()[object])) return false;
  if (any_hides([&](Frame const& frame) { return object_box(scene_, object, frame); })) return true;
  auto const& bodies = scene_.bodies();
  auto const first = bodies.first_of_object()[object], last = bodies.first_of_object()[object + 1];
  if (last - first < 2) return false;
  for (auto b = first; b < last; ++b)
    if (!any_hides([&](Frame const& frame) { return body_box(bodies, b, frame); })) return false;
  return true;
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
