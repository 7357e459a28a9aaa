#pragma once

#include "visibility/scene/bounding_hierarchy.hpp"
#include "visibility/scene/prepared_scene.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// What is looked for in a 2.5D scene, apart from what hides: the faces of a scene's objects as convex pieces. They
/// hide nothing, neither each other nor themselves, and need not form a height field.
///
/// From whatever point one looks, what lies above a visible point of the same vertical line is visible too, as only
/// columns hide. So of boxes, prisms and convex solids the faces that look up and the vertical ones suffice; of meshes
/// all triangles are kept. Faces without area are left out.
/// Built once; const afterwards. Keeps a reference to the prepared scene, which must outlive it.
/// Source: [Bittner05, §3]; proofs/occludees.md.
class Occludees {
public:
  /// A plane convex polygon: corners `first` to `first + count` of all corners.
  struct Piece {
    std::uint32_t first, count;
    std::uint32_t upper;  ///< of a wall: points of its upper boundary, which follow the corners; 0: not vertical
    std::uint32_t object;
    bool is_wall() const { return upper != 0; }
  };

  /// Throws BadInput for a scene with balls.
  explicit Occludees(PreparedScene const& scene);

  PreparedScene const& scene() const { return *scene_; }
  std::size_t object_count() const { return scene_->scene().objects.size(); }
  std::span<Piece const> pieces() const { return pieces_; }  ///< in object order
  /// Counterclockwise in plan; those of a wall in either direction.
  std::span<Point3d const> corners(Piece const& p) const { return {points_.data() + p.first, p.count}; }
  /// The upper boundary of a wall, from one end to the other in plan.
  std::span<Point3d const> upper_boundary(Piece const& p) const
  {
    return {points_.data() + p.first + p.count, p.upper};
  }
  Box const& bounds(std::uint32_t piece) const { return bounds_[piece]; }
  /// Items: positions in pieces().
  BoundingHierarchy const& hierarchy() const { return hierarchy_; }

private:
  void add(std::uint32_t object, Box const& box);
  void add(std::uint32_t object, Prism const& prism);
  void add(std::uint32_t object, ConvexPolyhedron const& polyhedron);
  void add_triangle(std::uint32_t object, Point3d const& a, Point3d const& b, Point3d const& c);
  void add_top(std::uint32_t object, std::span<Point3d const> corners);
  void add_wall(std::uint32_t object, Point2d const& a, Point2d const& b, double bottom, double top);
  void add_piece(Piece piece, std::span<Point3d const> points);

  PreparedScene const* scene_;
  std::vector<Point3d> points_;
  std::vector<Piece> pieces_;
  std::vector<Box> bounds_;
  BoundingHierarchy hierarchy_;
};

}  // namespace visibility
