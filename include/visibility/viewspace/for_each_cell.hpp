#pragma once

#include "visibility/scene/view_cell.hpp"
#include "visibility/viewspace/partition.hpp"

#include <functional>
#include <memory>

namespace visibility {

/// What the work on a cell leaves for the cells inside it; whatever a method wants it to be. Null: nothing.
using CellState = std::shared_ptr<void const>;

/// Work on one cell of a partition, given what its parent left; null for the coarsest level. Called from several
/// threads at once, for different cells.
using CellWork =
  std::function<CellState(std::size_t level, std::size_t index, ViewCell const&, CellState const& parent)>;

/// Calls `work` for every cell of every level, a parent before its children, cells in parallel (oneTBB; limit the
/// threads by its global_control). The state of a parent is released when its children are done. What `work` throws is
/// thrown here, once running calls have ended.
void for_each_cell(Partition const& partition, CellWork const& work);

}  // namespace visibility
