#pragma once

#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace visibility {

/// Pairs of cells whose bounding boxes share a point, and of a cell that has none such the nearest ones; at most a few
/// dozen for each cell. Each pair once, the lower position first, ascending. A choice: who relies on it loses space,
/// not correctness.
std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours(std::span<ViewCell const> cells);

}  // namespace visibility
