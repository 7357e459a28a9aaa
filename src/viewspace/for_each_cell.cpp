#include "visibility/viewspace/for_each_cell.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <numeric>
#include <vector>

namespace visibility {

namespace {

void descend(Partition const& partition, CellWork const& work, std::size_t level,
             std::vector<std::size_t> const& indices, CellState const& parent)
{
  oneapi::tbb::parallel_for(std::size_t{0}, indices.size(), [&](std::size_t i) {
    std::size_t const index = indices[i];
    CellState const state = work(level, index, ViewCell(partition.cell(level, index)), parent);
    if (level + 1 < partition.levels()) descend(partition, work, level + 1, partition.children(level, index), state);
  });
}

}  // namespace

void for_each_cell(Partition const& partition, CellWork const& work)
{
  std::vector<std::size_t> coarsest(partition.cell_count(0));
  std::iota(coarsest.begin(), coarsest.end(), std::size_t{0});
  descend(partition, work, 0, coarsest, nullptr);
}

}  // namespace visibility
