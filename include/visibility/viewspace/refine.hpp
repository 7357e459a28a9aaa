#pragma once

#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/viewspace/for_each_cell.hpp"

#include <chrono>
#include <concepts>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace visibility {

/// A method whose sets get cheaper inside a cell whose set is known.
template <class M>
concept RefinableMethod = requires(M const& method, typename M::Remainder const& rest, ViewCell const& cell)
{
  {
    method(rest, cell)
    } -> std::same_as<PotentiallyVisibleSet>;
  {
    method.refine(rest, cell)
    } -> std::same_as<std::pair<PotentiallyVisibleSet, typename M::Remainder>>;
};

/// The set of one cell and the seconds it took.
struct CellSet {
  PotentiallyVisibleSet set;
  double seconds = 0;
};

/// The sets of all cells of a partition, by level and position. The cells of each level start from what their parent
/// left, so that most of the scene is looked at once for many cells; the sets are those that each cell would have by
/// itself. The same for any number of threads. `methods` holds one method for each level, the coarsest first; none may
/// be finer in granularity than the next. `done(level)` is told of each finished cell, from any thread.
/// Throws std::invalid_argument if there is not one method for each level.
/// Source: [CohenOr98, 5, optimization 6].
template <RefinableMethod M>
std::vector<std::vector<CellSet>> refine(
  PreparedScene const& scene, Partition const& partition, std::vector<M> const& methods,
  std::function<void(std::size_t)> const& done = [](std::size_t) {})
{
  using Remainder = typename M::Remainder;
  if (methods.size() != partition.levels()) throw std::invalid_argument("one method is needed for each level");
  std::vector<std::vector<CellSet>> out(partition.levels());
  for (std::size_t level = 0; level < out.size(); ++level) out[level].resize(partition.cell_count(level));
  auto const whole_scene = std::make_shared<Remainder const>(scene);
  for_each_cell(partition, [&](std::size_t level, std::size_t index, ViewCell const& cell, CellState const& parent) {
    auto const start = std::chrono::steady_clock::now();
    Remainder const& rest = parent ? *static_cast<Remainder const*>(parent.get()) : *whole_scene;
    CellSet& result = out[level][index];
    CellState left;
    if (level + 1 < partition.levels()) {
      auto [set, remainder] = methods[level].refine(rest, cell);
      result.set = std::move(set);
      left = std::make_shared<Remainder const>(std::move(remainder));
    } else {
      result.set = methods[level](rest, cell);
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    done(level);
    return left;
  });
  return out;
}

}  // namespace visibility
