#pragma once

#include "visibility/scene/view_cell.hpp"

#include <optional>
#include <utility>

namespace visibility {

/// Of a box the longest side; of a polytope the greatest extent along one of its edges. Rounded, in metres.
double longest_extent(ViewCell const& cell);

/// Two cells within the given one that together cover it, cut at the middle of its longest extent. Of a box two boxes.
/// Of a polytope its vertices on either side with points of the edges that cross: points of the edges exactly, so the
/// two cover the cell wherever these points lie; where they lie in a plane, as in a prism cut across, the two tile it.
/// Empty if a cell is too thin for its coordinates, or if an edge has no such point in doubles; for cells that are
/// `divisible` that is after some twenty cuts.  Proof: proofs/preprocess.md, "Halves".
std::optional<std::pair<ViewCell, ViewCell>> halves(ViewCell const& cell);

/// The cell, or one a little larger around it whose edges have points in doubles. A box stays as it is, and a cell with
/// coordinates of few bits; of others vertices move outward onto a grid, of 2^-31 times the coordinates, or finer for
/// small cells. An upright prism stays one. Exact: it contains the cell.
ViewCell divisible(ViewCell const& cell);

}  // namespace visibility
