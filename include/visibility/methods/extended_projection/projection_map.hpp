#pragma once

#include "visibility/methods/extended_projection/convex_part.hpp"
#include "visibility/methods/extended_projection/options.hpp"
#include "visibility/raster/contours.hpp"
#include "visibility/raster/hierarchical_depth_map.hpp"
#include "visibility/raster/pixel_region.hpp"

#include <cstdint>

namespace visibility::extended_projection {

/// The plane w = `plane` of a frame with its Depth Map [Durand00, 2.3, 2.4]. What a pixel that stores z says: for every
/// point X of the closed pixel and every point c of the closed cell, the line cX meets an occluder at some w with
/// near < w and w - near <= z. So whatever is seen through the pixel beyond z is hidden, wherever the plane stands.
class ProjectionMap {
public:
  /// Keeps a reference to the cell. Requires: plane > cell.near.
  ProjectionMap(CellViews const& cell, double plane, Grid const& grid);
  /// The next plane of a sweep: what another map knows, on this plane [Durand00, 5.1]. A pixel is covered if the lines
  /// from all of the cell to all of the pixel pass covered pixels there; it takes the farthest of their depths. So
  /// depths stay those of occluders. Requires: the same cell; near < from.plane() < plane.
  ProjectionMap(ProjectionMap const& from, double plane, Grid const& grid, Reprojection = Reprojection::windows);

  CellViews const& cell() const { return *cell_; }
  double plane() const { return plane_; }
  Grid const& grid() const { return region_.grid(); }
  DepthMap<float> const& depths() const { return map_.map(); }

  /// Whether it seems worth while to add what lies in a box of the frame: its views seem to have a pixel in common
  /// where the map does not hold something nearer. A choice: rounded, and looks at boxes.
  bool seems_useful(Box const& box) const;
  /// Adds the Projection of a part: the intersection of its views from the vertices of the cell [Durand00, 3.2], at the
  /// Depth of its farthest point, or, where that is less, one that is affine over the plane. Requires: near < w for all
  /// of the part, which is on one side of the plane. Returns the number of pixels.
  std::int64_t add(std::span<PartPoint const> part, PartDepth depth = PartDepth::part);
  /// Whether the section of a box of the frame with the plane has a pixel where the map does not hold something nearer
  /// than the plane. A choice.
  bool slice_seems_useful(Box const& box) const;
  /// Adds a region of the plane w = `at` that sight lines reach through an occluder only: from all of the cell to each
  /// point (u, v, at) inside the contours they meet an occluder at w <= at. Contours as in inner_even_odd, `error` of
  /// their points; it is seen on the map's plane, and its depth is that of the map's plane.
  /// Requires: at <= plane. Returns the number of pixels; none if at <= near.
  std::int64_t add_slice(std::span<ContourEdge const> contours, double error, double at, double low);
  /// Brings the pyramid up to date: queries are right before it, and fast after.
  void refresh() { map_.refresh(); }

  /// Whether every sight line from the cell to the box, in the frame, certainly meets an occluder before it arrives.
  /// Through the Projection of the box, the bounding rectangle of its views [Durand00, 3.1].
  bool hides(Box const& box) const;
  /// The same through the improved Projection [Durand00, 4.2], from the cell's side next to the plane, which the paper
  /// leaves out (proofs/extended_projection.md, "Improved Projection"). Requires: a box cell. Of a map that came from
  /// another, boxes that reach before that one's plane are not hidden.
  bool hides_improved(Box const& box) const;

private:
  ProjectionMap(CellViews const& cell, double plane, double improved_from, Grid const& grid, DepthMap<float> depths);
  void write_affine_depth(std::span<PartPoint const> part, double farthest);
  bool hides(Bounded const& u0, Bounded const& u1, Bounded const& v0, Bounded const& v1, double w) const;

  CellViews const* cell_;
  double plane_;
  double improved_from_;  // boxes from here on may be hidden by the improved Projection
  HierarchicalDepthMap<float> map_;
  PixelRegion region_;          // scratch
  Spans spans_;                 // scratch
  std::vector<Point2d> views_;  // scratch: of all vertices, one after the other
  std::vector<Point2d> errors_;
};

}  // namespace visibility::extended_projection
