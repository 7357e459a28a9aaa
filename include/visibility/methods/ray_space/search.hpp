#pragma once

#include "visibility/methods/ray_space/counts.hpp"
#include "visibility/methods/ray_space/occludee.hpp"
#include "visibility/methods/ray_space/occluder.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace visibility::ray_space {

/// The interleaved traversal of [Leyvand03, figure 10]: nodes of the hierarchy and objects by their distance from the
/// cell; what is hidden is dropped with all below, and the occluders of visible objects are entered. Gates know from
/// which distance on they hold, so the order is good for speed alone.
class Search {
public:
  /// Requires: Frame::in_domain(cell.bounds()).
  Search(PreparedScene const& scene, ViewCell const& cell, Options const& options);

  /// The potentially visible objects, ascending.
  std::vector<std::uint32_t> run();
  /// After run(): the triangles of these objects that are not hidden one by one.
  std::vector<std::uint32_t> triangles_of(std::vector<std::uint32_t> const& objects);

  Counts const& counts() const { return counts_; }

private:
  bool is_visible(std::uint32_t object);
  bool is_part_visible(ConvexBodies::Body const& body, Box const& bounds);
  bool is_polygon_visible(std::span<Point3d const> polygon);
  void enter(std::uint32_t object);
  bool enter_occluder(std::uint32_t object, std::uint32_t occluder);

  PreparedScene const* scene_;
  ViewCell const* cell_;
  Options options_;
  std::vector<Frame> frames_;
  std::vector<OcclusionMap> maps_;
  std::vector<RefinedMap> refined_;  // none, or one for each map
  OccludeeTest test_;
  double floor_;  // no point of the cell and of what is looked for lies lower
  OccluderWriter writer_;
  Counts counts_;
  Chords chords_;
  std::vector<Point3d> vertices_;
  std::vector<Box> inner_;
};

}  // namespace visibility::ray_space
