#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/scene/height_field.hpp"

#include <cstdint>
#include <vector>

namespace visibility {

/// How a sight line crosses a top edge a -> b in plan. From right to left it enters the edge's column and may see the
/// wall below the edge; from left to right it leaves the column and may see its top just before the edge. A curtain has
/// no top, and is entered from both sides: `leaving` means entered from the left.
enum class Crossing : std::uint8_t { entering, leaving };

/// The points a + t (b - a) with low < t < high. Invariant: 0 <= low < high <= 1.
struct OpenInterval {
  RationalNumber low, high;
  friend bool operator==(OpenInterval const&, OpenInterval const&) = default;
};

/// The parts of an edge where it is exposed: maximal open intervals in ascending order.
struct ExposedParts {
  bool all = true;                  ///< the whole edge; then `parts` is empty and nothing was allocated
  std::vector<OpenInterval> parts;  ///< empty and not `all`: exposed nowhere
};

/// The parts of an edge that no other column covers there, at the edge itself; whatever stands further off is ignored.
/// A column F covers the edge where F has area next to it, and
///  - entering: the area lies to the right, and F's top is at least as high as the edge. The wall just below the edge
///  is
///    buried: a sight line that arrives from the right runs inside F just before it;
///  - leaving: the area lies to the left, and F's top is higher just left of the edge than the top of the edge's
///  column.
///    Coinciding tops do not cover each other;
///  - leaving, the edge a curtain: as for entering, with the area to the left.
/// Other columns of the same object count, curtains and the edge's own column do not. A part may lack single points
/// where it would have been allowed to keep them: covered intervals are closed.
/// Exact for all finite input. Laws: order -- of the columns does not matter;  split -- a column cut in two covers the
/// same;  rotation -- the first corner of a column does not matter.
/// Cost: one query of column_hierarchy(), a few orient2d per column that meets the edge's box and is not lower than the
/// edge; rational numbers only where part of the edge is covered.
/// Requires: edge < field.edges().size(). Instantiated for Filtered and Rational.  Source: docs/meaning.md.
template <Arithmetic A = Filtered>
ExposedParts exposed_parts(HeightField const& field, std::uint32_t edge, Crossing crossing);

}  // namespace visibility
