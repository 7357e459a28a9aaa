#pragma once

#include "visibility/methods/exact_25d/crossed_edge.hpp"
#include "visibility/scene/potentially_visible_set.hpp"

#include <optional>
#include <span>

namespace visibility::exact_25d {

/// A sight line as the search finds it: it runs from `from`, in the cell's interior, towards `end` on a top edge or a
/// seam, passes above all edges in between, and can be lowered a little at its end.
struct FoundLine {
  Point3q from, end;
  std::uint32_t column;  ///< of which the wall or the top is seen
  bool sees_top;         ///< in front of `end`; otherwise the wall below it
};

/// The sight line as a witness: lowered until it ends in the relative interior of the wall or the top, and meets no
/// column before. Checked column by column, straight from the definition, so it does not rely on the method.
/// Empty if no such line is found: then the search was wrong, or columns reach into the cell.
std::optional<Witness> witness(HeightField const& field, FoundLine const& line);

/// Whether the segment [from, to) meets no column. Exact.
bool is_free(HeightField const& field, Point3q const& from, Point3q const& to);

}  // namespace visibility::exact_25d
