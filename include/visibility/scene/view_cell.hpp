#pragma once

#include "visibility/geometry/convex_polyhedron.hpp"

#include <optional>
#include <span>

namespace visibility {

/// The region one looks from: a convex polytope with interior, a box by default.
class ViewCell {
public:
  /// Throws std::invalid_argument unless box.has_interior() and its coordinates are finite.
  explicit ViewCell(Box const& box);
  /// The convex hull of the points. Throws std::invalid_argument if they are not finite or lie in one plane.
  static ViewCell hull(std::span<Point3d const> points);

  ConvexPolyhedron const& shape() const { return shape_; }
  std::span<Point3d const> vertices() const { return shape_.vertices; }
  Box const& bounds() const { return bounds_; }
  bool is_box() const { return is_box_; }

private:
  ViewCell() = default;
  ConvexPolyhedron shape_;
  Box bounds_;
  bool is_box_ = false;
};

/// Whether the point lies in the interior of the cell. Exact.
bool in_interior(ViewCell const& cell, Point3d const& point);
bool in_interior(ViewCell const& cell, Point3q const& point);

/// Whether the point lies in the closed cell. Exact.
bool contains(ViewCell const& cell, Point3d const& point);

/// Whether a facet plane of the cell has the whole box strictly outside (exact): then they share no point.
/// `false` says nothing, so whatever may meet the cell is treated as meeting it.
bool certainly_disjoint(ViewCell const& cell, Box const& box);

}  // namespace visibility
