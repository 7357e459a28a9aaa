#pragma once

#include "visibility/methods/extended_projection/occluder_projector.hpp"
#include "visibility/scene/object_selection.hpp"
#include "visibility/scene/prepared_scene.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace visibility::extended_projection {

/// Tests occludees against maps in all directions. A box that has a side of the cell's bounding box before it is seen
/// in that direction only as a whole: all sight lines to it run that way.
class OccludeeSearch {
public:
  struct Counts {
    std::uint64_t boxes_tested = 0, groups_hidden = 0;
  };

  /// Keeps references.
  OccludeeSearch(PreparedScene const& scene, ViewCell const& cell, std::vector<ProjectionMap> const& maps,
                 OccluderProjector const& projector, bool improved)
    : scene_(scene), cell_(cell), maps_(maps), projector_(projector), improved_(improved)
  {
  }

  /// Whether a map hides the box. Boxes that meet the cell's bounds are not hidden.
  bool hides(Box const& box);
  /// Whether maps hide the object, or each of its bodies.
  bool hides_object(std::uint32_t object);
  /// The objects that are not hidden, ascending; `visible(object)` is called as they are found, near to far. Only those
  /// of `among`, if it is given.
  std::vector<std::uint32_t> visible_objects(std::function<void(std::uint32_t)> const& visible,
                                             ObjectSelection const* among = nullptr);

  Counts const& counts() const { return counts_; }

private:
  template <class BoxIn>
  bool any_hides(BoxIn&& box_in);

  PreparedScene const& scene_;
  ViewCell const& cell_;
  std::vector<ProjectionMap> const& maps_;
  OccluderProjector const& projector_;
  bool improved_;
  Counts counts_;
};

}  // namespace visibility::extended_projection
