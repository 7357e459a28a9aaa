#pragma once

#include "random.hpp"
#include "visibility/evidence/ray_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace visibility::detail {

/// Chooses origins of rays in the interior of a cell.
class CellPoints {
public:
  CellPoints(ViewCell const& cell, RayScene const& rays);

  /// Uniform in the volume, or near the boundary: corners and edges see most, the top ones above all.
  Point3d any(Random& random) const;
  Point3d near_boundary(Random& random) const;
  Point3d in_volume(Random& random) const;
  /// A point of the cell near p, `scale` cell sizes away at most.
  Point3d near(Random& random, Point3d const& p, double scale) const;
  /// A point of the line through a and b in the cell's interior, if there is one.
  std::optional<Point3d> on_line(Random& random, Point3d const& a, Point3d const& b) const;

  Point3d centre() const { return centre_; }
  double size() const { return size_; }

private:
  /// Moves p to the grid of rays and into the interior, towards the centre as far as needed.
  Point3d settled(Point3d const& p) const;
  Point3d boundary_point(Random& random) const;

  ViewCell const& cell_;
  RayScene const& rays_;
  Point3d centre_{};
  double size_ = 0;
  std::vector<double> volumes_;  // running sums: of the tetrahedra from the centre to each facet
};

}  // namespace visibility::detail
