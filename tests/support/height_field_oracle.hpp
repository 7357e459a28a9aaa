#pragma once

#include "visibility/scene/potentially_visible_set.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Exact from-region visibility in height fields of few columns, straight from the definition. Slow, independent of
/// every method of the library, and sure of what it says: visible is proved by a sight line in rationals, hidden by
/// signs of quadratic forms on convex sets of lines of the plane. How and why: proofs/height_field_oracle.md.
namespace visibility::oracle {

/// A convex polygon of the plane, solid from its top down to minus infinity, closed.
/// Requires: corners counterclockwise with area; the top is planar: equal heights, or three corners.
struct Column {
  std::vector<Point3d> corners;  ///< plan position, and height of the top there
  std::uint32_t object;          ///< columns may share an object
  std::vector<bool> inner;       ///< inner[i]: the side from corner i to i + 1 is no face; empty: every side is one
};

/// What occludes nothing: convex planar polygons in space, each in any position. Corners may lie on sides of the
/// polygon or repeat; polygons without area count for nothing.
struct Occludee {
  std::vector<std::vector<Point3d>> polygons;
};

/// A flat-topped prism. Requires: counterclockwise convex footprint with area; bottom < top.
struct Cell {
  std::vector<Point2d> footprint;
  double bottom, top;
};

enum class Verdict { hidden, visible, undecided };

/// By object or occludee. One that is visible and meets the closed cell has no witness, every other visible one has.
struct Answer {
  std::vector<Verdict> verdict;
  std::vector<std::optional<Witness>> witness;
};

/// Visible by positive measure (proofs/visibility.md): objects seen along a null set of lines only are hidden.
/// `undecided` means that the sight lines of an object, if any, are confined to a set too thin for the subdivision.
/// Throws std::invalid_argument if a column reaches the cell's top inside the cell's footprint, or if the input breaks
/// what Column and Cell require. At most 60 columns.
Answer visible_objects(std::span<Column const> columns, std::size_t object_count, Cell const& cell);

/// By occludee: the same question for what occludes nothing, neither others nor itself. Columns are no targets here and
/// their objects play no part. Throws as above, and if a polygon is not planar or not convex.
Answer visible_occludees(std::span<Column const> columns, std::span<Occludee const> occludees, Cell const& cell);

/// How sight lines cross an edge of a top from corner `side` to the next: from its right to its left, so that they see
/// the wall below it, or from its left to its right, so that they see the top just before it.
enum class Crossing { entering, leaving };

/// Whether some sight lines from the cell reach the point at a + t (b - a) of a column's top edge ab, crossing it that
/// way, above every column before it; it does not matter whether the side is a face. Hidden or visible, never
/// undecided. The visible positions are open but for finitely many, whose verdict may differ from that of their
/// neighbours: those where a corner of a column or of the cell, or a crossing of sides, has its plan on the edge.
/// Requires: 0 < t < 1. Throws as above.
Verdict sees_edge_at(std::span<Column const> columns, std::size_t column, std::size_t side, Crossing crossing,
                     RationalNumber const& t, Cell const& cell);
/// Such a sight line, if there are any: to the wall right below that point, or to the top right before it.
std::optional<Witness> sight_line_to_edge(std::span<Column const> columns, std::size_t column, std::size_t side,
                                          Crossing crossing, RationalNumber const& t, Cell const& cell);

/// Whether the witness proves what it says: `from` in the cell's interior, `to` in the relative interior of a face of a
/// column of the object, no column met by the segment before `to`. Straight from the definition, in rationals.
bool confirms(std::span<Column const> columns, Cell const& cell, Witness const& witness);

/// The same for an occludee: `to` in the relative interior of one of its polygons. The witness's object is not looked
/// at.
bool confirms(std::span<Column const> columns, Occludee const& occludee, Cell const& cell, Witness const& witness);

/// Whether the closed column and the closed cell share a point.
bool meets(Column const& column, Cell const& cell);
/// Whether a polygon with area and the closed cell share a point.
bool meets(Occludee const& occludee, Cell const& cell);

/// Throws std::invalid_argument naming what the input breaks.
void validate(std::span<Column const> columns, std::size_t object_count, Cell const& cell);
void validate(Occludee const& occludee);

}  // namespace visibility::oracle
