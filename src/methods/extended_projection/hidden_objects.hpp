#pragma once

#include "visibility/scene/object_selection.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace visibility::extended_projection {

/// Which objects, and groups of them, are known to be hidden from a cell; what is hidden stays so. Keeps references.
class HiddenObjects {
public:
  /// What is not `among` the objects of interest, if these are given, is taken as hidden.
  HiddenObjects(PreparedScene const& scene, ViewCell const& cell, ObjectSelection const* among)
    : scene_(scene), cell_(cell), nodes_(scene.object_hierarchy().nodes().size()),
      objects_(scene.scene().objects.size())
  {
    if (among == nullptr) return;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) nodes_[i] = !among->any_below(i);
    for (std::uint32_t o = 0; o < objects_.size(); ++o) objects_[o] = !among->holds(o);
  }

  void hide(std::uint32_t object) { objects_[object] = true; }
  /// All objects below a node of the hierarchy of objects.
  void hide_group(std::uint32_t node) { nodes_[node] = true; }

  /// Walks the rest of the hierarchy of objects, near to far: enter(node, box) returns whether to descend,
  /// visit(object) is called for objects that are not hidden.
  template <class Enter, class Visit>
  void walk_rest(Enter&& enter, Visit&& visit) const
  {
    scene_.object_hierarchy().front_to_back(
      cell_.bounds(), [&](std::uint32_t node, Box const& box) { return !nodes_[node] && enter(node, box); },
      [&](std::uint32_t object) {
        if (!objects_[object]) visit(object);
      });
  }

  /// The objects that are not hidden, ascending.
  std::vector<std::uint32_t> rest() const
  {
    std::vector<std::uint32_t> out;
    walk_rest([](std::uint32_t, Box const&) { return true; }, [&](std::uint32_t object) { out.push_back(object); });
    std::ranges::sort(out);
    return out;
  }

private:
  PreparedScene const& scene_;
  ViewCell const& cell_;
  std::vector<char> nodes_, objects_;
};

}  // namespace visibility::extended_projection
