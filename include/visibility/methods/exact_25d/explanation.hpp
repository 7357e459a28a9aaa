#pragma once

#include "visibility/line_space/portal_sequence.hpp"
#include "visibility/line_space/quadratic_number.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace visibility::exact_25d {

/// A position on an edge as seen from the cell, from its left end (0) to its right end (1): (p + q sqrt(d)) / r.
using Position = QuadraticNumber<RationalNumber>;

/// The positions between two, the ends included.
struct PositionRange {
  Position low, high;
};

/// A top edge of which sight lines reach parts, running above everything before it. Lines that cross it into its column
/// see the wall below it, lines that cross it out of the column the top before it; an edge may be seen in both ways.
struct VisibleEdge {
  std::uint32_t object;
  PortalSequence::Edge edge;         ///< left and right end as seen
  bool sees_top;                     ///< the top before it; otherwise the wall below it
  std::vector<PositionRange> parts;  ///< ascending, disjoint, of positive length
};

/// A cell of the subdivision of 2D line space: the lines of a funnel, and the occluders that they cross.
/// Shadow planes of an occluder: two through its edge and an end of the source, two through an end of it and the
/// source.
struct LineSpaceCell {
  PortalSequence::Edge entry, exit;  ///< sides of the view cell's outline, with its height: the sources
  std::vector<std::array<Point2d, 2>> bounds;
  std::vector<PortalSequence::Edge> occluders;
};

/// What bounds the penumbra of an occluder: four planes, two through its edge and an end of the source, two through the
/// source and an end of the edge [Bittner05, §5.3].
struct Shadow {
  PortalSequence::Edge source, occluder;
};

/// What a query found on its way, for pictures and for other programs [Bittner05, figures 7 to 9].
struct Explanation {
  std::vector<VisibleEdge> edges;
  std::vector<LineSpaceCell> cells;
  std::vector<Shadow> shadows;  ///< of all occluders of the cells, each pair once
};

}  // namespace visibility::exact_25d
