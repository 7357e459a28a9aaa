#pragma once

#include "visibility/geometry/box.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace visibility {

/// A box of viewspace divided into box cells, coarse to fine: each cell of a level is divided into equal parts, the
/// cells of the next. Cells of a level share their boundaries and tile the region exactly; children tile their parent.
/// Source: [CohenOr98, 6].
class Partition {
public:
  /// `sizes`, in metres, one for each level, the coarsest first: no cell is longer along an axis, and there are as few
  /// as that allows. Throws std::invalid_argument, with the reason in one line, unless the region has interior and is
  /// finite, there is a level, sizes are positive and do not grow, and no level has more than 10^8 cells or cells too
  /// thin for double coordinates.
  Partition(Box const& region, std::span<Point3d const> sizes);

  std::size_t levels() const { return cuts_.size(); }
  std::size_t cell_count(std::size_t level) const;
  /// Cell `index` of a level: x runs fastest, then y, then z.
  Box cell(std::size_t level, std::size_t index) const;
  /// Positions in the next level of the cells inside this one, ascending. Requires: not the last level.
  std::vector<std::size_t> children(std::size_t level, std::size_t index) const;

private:
  using Cuts = std::array<std::vector<double>, 3>;  // per axis: region's low end, cuts, high end

  std::array<std::size_t, 3> shape(std::size_t level) const;
  std::array<std::size_t, 3> position(std::size_t level, std::size_t index) const;

  std::vector<Cuts> cuts_;  // per level
  std::vector<std::array<std::size_t, 3>>
    parts_;  // per level and axis: parts that a cell of the level before is cut into
};

}  // namespace visibility
