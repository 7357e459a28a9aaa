#pragma once

#include "visibility/scene/scene_builder.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace visibility::generators {

/// A town house in its own frame: the plan is [-length/2, length/2] x [-width/2, width/2], the ground z = 0, the ridge
/// along x.
struct House {
  double length = 0, width = 0, storey = 0;       ///< m
  std::uint32_t floors = 0;                       ///< at least 1
  std::uint32_t bays_along = 0, bays_across = 0;  ///< of the facades along x and along y, at least 1
  double recess = 0;                              ///< depth of the windows, m, less than a third of a bay
  double roof = 0, hip = 0;                       ///< height of the ridge above the eaves; its distance to each end
  std::vector<Box> chimneys;                      ///< solids of their own that start inside the house
  std::function<bool()> window;                   ///< asked once for every bay of every floor
};

/// Where the frame stands in the scene.
using Placement = std::function<Point3d(Point3d const&)>;

/// The house as one closed mesh (every edge in two facets, once each way), facets counterclockwise from outside, and
/// its chimneys as closed boxes. A bay with a window takes 18 triangles (a frame of four, four reveals and the pane,
/// two triangles each), one without 2; the roof takes 2 more than there are bays around the house, the floor as many
/// as those bays, and a chimney 12. There are no T-junctions: neighbours share all their vertices.
void add_house(SceneBuilder& scene, House const& house, Placement const& placement);

}  // namespace visibility::generators
