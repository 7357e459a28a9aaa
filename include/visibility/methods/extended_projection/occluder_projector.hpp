#pragma once

#include "visibility/methods/extended_projection/projection_map.hpp"
#include "visibility/scene/prepared_scene.hpp"

#include <cstdint>

namespace visibility::extended_projection {

/// Projects the convex occluders of a scene: cuts each into parts for which the vertices of the cell suffice, and adds
/// these to a map.
///
/// Upright solids that stand on the ground or reach below it are carried on downwards: no sight line to what stands
/// above passes below the ground if the cell lies above it, so for this nothing changes but that rounding at the foot
/// of walls costs no pixels, and that parts of a plane below the ground are covered (proofs/extended_projection.md,
/// "Ground"). The ground is that of the scene, or its lowest point for a cell that is lower.
class OccluderProjector {
public:
  OccluderProjector(PreparedScene const& scene, ViewCell const& cell, PartDepth depth = PartDepth::part);

  /// Adds the occluder, or its part with w <= until, to the map; returns the number of pixels written.
  /// Requires: the occluder blocks from the cell (Occluders::blocks_from).
  std::int64_t add(std::uint32_t occluder, ProjectionMap& map, double until = HUGE_VAL);

  /// What is nearer to the cell than this, in metres, is cut off from now on; at first a share of a plane's distance
  /// is.
  void cut_nearer_than(double distance) { nearest_ = distance; }

  bool is_above_ground() const { return is_above_ground_; }  ///< the cell; if it is not, nothing is carried down
  double ground() const { return ground_; }                  ///< its z, metres
  /// Whether what lies in the box, of the scene, may be hidden by what this adds.
  bool may_hide(Box const& box) const { return !is_above_ground_ || box.min.z >= ground_; }
  /// Where it carries what stands on the ground down to, in frames with a vertical v.
  double deep() const { return deep_along(0); }

private:
  void collect(std::uint32_t occluder, Frame const& frame);
  double deep_along(double rise) const;
  void carry_down(double deep);

  PreparedScene const* scene_;
  ViewCell const* cell_;
  PartDepth depth_;
  bool is_above_ground_;
  double ground_, height_;
  double nearest_ = 0;             // 0: a share of the distance
  std::vector<Point3d> vertices_;  // scratch
  ConvexPart part_;                // scratch
};

}  // namespace visibility::extended_projection
