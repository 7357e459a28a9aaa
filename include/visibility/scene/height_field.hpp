#pragma once

#include "visibility/scene/bounding_hierarchy.hpp"
#include "visibility/scene/scene.hpp"

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// A pair of columns of different objects whose tops meet within the plan of the first, S: past the seam the top of the
/// second, F, is the higher one. It is a *foot* where an edge of F stands on S's top (from the left of the edge F's
/// inside, from the right S), a *crease* where the two top planes cross. S's top is seen just before the seam along
/// sight lines that run on to F's side. scene/seams.hpp has the parts where nothing else covers S there.
struct Seam {
  static constexpr std::uint32_t no_edge = 0xffffffff;
  std::uint32_t column;  ///< S
  std::uint32_t other;   ///< F
  std::uint32_t edge;    ///< of F, a foot; no_edge: a crease
  bool from_left;        ///< S is seen on the left of the edge a -> b of a curtain; otherwise false
  auto operator<=>(Seam const&) const = default;
  bool is_crease() const { return edge == no_edge; }
};

/// A 2.5D scene: columns, each a convex polygon in plan with a planar top, solid from the top down without end, and the
/// edges of their tops. A sight line that stays above all top edges that it crosses in plan stays above all columns.
///
/// Boxes and convex solids give their upper facets, prisms a convex partition of their footprint, triangles (of any
/// orientation) themselves; vertical triangles give curtains, columns without width. Everything below an upper surface
/// counts as solid, so the reading is faithful where nobody looks below one: `raised()` says where that is in doubt.
/// Built once; const afterwards. Keeps a reference to the scene, which must outlive it.
/// Source: [Bittner05, §3]; proofs/exact_2_5d.md.
class HeightField {
public:
  /// Corners `first` to `first + count` of `corners()`, counterclockwise in plan, their tops in one plane; or, for a
  /// curtain, the two ends of an edge.
  struct Column {
    std::uint32_t first, count;
    std::uint32_t object;
    bool is_curtain() const { return count == 2; }
    bool is_flat = true;  ///< all corners equally high
  };
  /// A side of a column, seen from above the column lies to the left of a -> b. A curtain has one edge for both sides.
  struct TopEdge {
    Point3d a, b;
    std::uint32_t column;
  };

  /// Throws BadInput for a scene with balls, which have no top edges, or with objects that do not occlude (split()
  /// takes them out).
  explicit HeightField(Scene const& scene);

  Scene const& scene() const { return *scene_; }
  std::span<Column const> columns() const { return columns_; }  ///< in object order; every curtain has an edge
  std::span<Point3d const> corners(Column const& c) const { return {corners_.data() + c.first, c.count}; }
  /// In object order. Left out are sides below a higher one of the same object, and those that two columns of an object
  /// share where the top is flat or a valley: a sight line above all other edges is above these
  /// (proofs/height_field_edges.md, lemma 1).
  std::span<TopEdge const> edges() const { return edges_; }
  std::uint32_t object_of(TopEdge const& e) const { return columns_[e.column].object; }

  /// Lower ends of bounding boxes: far enough below everything to stand for minus infinity.
  static constexpr double bottomless = -0x1p100;
  /// Items: positions in edges(). Bounds are those of the curtains, from the higher end down without end.
  BoundingHierarchy const& edge_hierarchy() const { return edge_hierarchy_; }
  /// Items: positions in columns(). Bounds are those of the columns, down without end.
  BoundingHierarchy const& column_hierarchy() const { return column_hierarchy_; }

  /// Where the top of a column ends at that of another object, inside its plan, and is exposed there: those of
  /// find_seams() that have parts, in its order.
  std::span<Seam const> seams() const { return seams_; }
  /// Boxes that contain the parts of the seams, up to the lower of the two tops; position by position.
  std::span<Box const> seam_bounds() const { return seam_bounds_; }
  /// Items: positions in seams(). Bounds are seam_bounds().
  BoundingHierarchy const& seam_hierarchy() const { return seam_hierarchy_; }

  double ground() const { return ground_; }  ///< least height in the scene
  /// Objects with room below an upper surface, where sight lines may pass that a height field does not know: with a box
  /// that neither reaches down to the ground nor stands on one of the object that does, a prism that ends above it, or
  /// convex solids and triangles that hang over or lack a wall. 0: what is exact for the height field is exact for the
  /// scene (proofs/exact_2_5d.md, "Walls").
  std::size_t raised() const { return raised_; }
  /// Prisms with an invalid footprint: their walls are curtains.
  std::size_t invalid_footprints() const { return invalid_footprints_; }

private:
  Scene const* scene_;
  std::vector<Point3d> corners_;
  std::vector<Column> columns_;
  std::vector<TopEdge> edges_;
  BoundingHierarchy edge_hierarchy_, column_hierarchy_;
  std::vector<Seam> seams_;
  std::vector<Box> seam_bounds_;
  BoundingHierarchy seam_hierarchy_;
  double ground_ = 0;
  std::size_t raised_ = 0, invalid_footprints_ = 0;
};

inline Box bounding_box(HeightField::TopEdge const& e)
{
  Box box;
  box.extend(e.a);
  box.extend(e.b);
  return box;
}

}  // namespace visibility
