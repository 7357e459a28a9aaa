#pragma once

#include "visibility/line_space/cell_outline.hpp"
#include "visibility/scene/height_field.hpp"

#include <vector>

namespace visibility::exact_25d {

/// What the columns in and under a view cell mean for a query; decided exactly.
struct CellContacts {
  /// Objects that are visible because a column of theirs meets the closed cell, or is seen from right above; ascending.
  std::vector<std::uint32_t> visible;
  /// Edges inside the outline of columns that reach the cell's top: what they hide from part of the cell is not
  /// modelled. Ascending.
  std::vector<std::uint32_t> ignored_edges;
  bool all_occlude = true;  ///< false if columns reach the cell's top inside its outline: edges may be ignored
  /// False if an edge is ignored, or a column rises into a cell that is not upright: the set is then conservative.
  bool exact = true;
};

/// `outline` is that of the cell. Cost: one query of column_hierarchy(); rationals for slanted tops that meet the
/// outline, and is_exposed_inside() for the objects under it.
CellContacts cell_contacts(HeightField const& field, ViewCell const& cell, CellOutline const& outline);

}  // namespace visibility::exact_25d
