#pragma once

#include "visibility/line_space/cell_outline.hpp"
#include "visibility/scene/exposed_parts.hpp"

#include <optional>

namespace visibility::exact_25d {

/// A piece of a segment of the plan, seen from the cell with these ends.
struct PlanSegment {
  Point2q left, right;
};
inline PlanSegment plan_segment(PortalSequence::Edge const& e)
{
  return {horizontal(exact(e.left)), horizontal(exact(e.right))};
}

/// The positions at which the segment runs along side `side` of the outline, crossed as lines cross it that leave by
/// that side; empty without length. Exact.
std::optional<OpenInterval> along_side(PlanSegment const& segment, CellOutline const& outline, std::size_t side);

/// The positions at which the segment runs inside the outline; empty without length. Exact.
std::optional<OpenInterval> inside(PlanSegment const& segment, CellOutline const& outline);

}  // namespace visibility::exact_25d
