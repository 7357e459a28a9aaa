#pragma once

#include "height_field_columns.hpp"

#include "visibility/scene/bounding_hierarchy.hpp"

#include <optional>

namespace visibility::height_field {

/// Whether the walls that a height field has below the edges of an object are there: made of vertical triangles of the
/// object, or beside columns of it. If all are, nothing is seen or passed below an upper surface
/// (proofs/exact_2_5d.md, "Walls"). Edges of boxes and prisms are taken to have theirs.
/// Exact for all finite input. Cost: a sort of the object's sides; of walls that are not divided as the tops above them
/// are, rational numbers.
class WallCover {
public:
  /// Keeps a reference. `ground`: where walls end, m.
  WallCover(ObjectColumns::Result const& object, double ground);

  /// Whether some part of a wall, of positive area, is neither. Without edges above the ground: false.
  bool has_open_wall();

private:
  enum class Beside : std::uint8_t { left, right, both };

  /// What fills part of the plane over a side, from one end of it to the other: from `lower_a`, `lower_b` up to a, b.
  struct Strip {
    Point3d a, b;  ///< lexicographically ordered in plan
    double lower_a, lower_b;
    Beside beside;  ///< of a -> b
  };

  void add_wall(std::array<Point3d, 3> const& corners);
  bool is_open(ObjectColumns::Edge const& edge, bool on_left);
  bool is_filled_by_strips(Point3d const& a, Point3d const& b, bool on_left) const;
  bool is_filled(Point3d const& a, Point3d const& b, bool on_left);
  BoundingHierarchy const& hierarchy();

  ObjectColumns::Result const& object_;
  double ground_;
  std::vector<Strip> strips_;
  std::optional<BoundingHierarchy> hierarchy_;  ///< of columns, then of walls; made when it is asked for
};

}  // namespace visibility::height_field
