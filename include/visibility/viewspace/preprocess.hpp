#pragma once

#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/viewspace/for_each_cell.hpp"
#include "visibility/viewspace/refine.hpp"

#include <concepts>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace visibility {

/// A method that can be asked about some objects alone, the others being known to be hidden.
template <class M>
concept RestrictableMethod = requires(M const& method, PreparedScene const& scene, ViewCell const& cell,
                                      std::span<std::uint32_t const> candidates)
{
  {
    method(scene, cell, candidates)
    } -> std::same_as<PotentiallyVisibleSet>;
};

/// What the cell around a cell has left for it.
struct ParentCell {
  std::span<std::uint32_t const> visible;  ///< its set, ascending
  CellState left;
};

/// A method as `preprocess` asks it: the set of a cell, given what the cell around it left (null for an initial cell),
/// and what it leaves for cells inside. Called from several threads at once.
using CellQuery = std::function<std::pair<PotentiallyVisibleSet, CellState>(ViewCell const&, ParentCell const* parent)>;

/// The query that a method makes of a scene, to which it keeps a reference. A restrictable method is asked about what
/// is visible from the parent alone, a refinable one starts from the remainder of the parent, others from the scene.
template <class M>
CellQuery cell_query(PreparedScene const& scene, M method)
{
  return [&scene, method = std::move(method)](ViewCell const& cell, ParentCell const* parent) {
    std::pair<PotentiallyVisibleSet, CellState> out;
    if constexpr (RestrictableMethod<M>) {
      out.first = parent != nullptr ? method(scene, cell, parent->visible) : method(scene, cell);
    } else if constexpr (RefinableMethod<M>) {
      using Remainder = typename M::Remainder;
      auto const from = parent != nullptr ? std::static_pointer_cast<Remainder const>(parent->left)
                                          : std::make_shared<Remainder>(scene);
      auto [set, rest] = method.refine(*from, cell);
      out = {std::move(set), std::make_shared<Remainder const>(std::move(rest))};
    } else {
      out.first = method(scene, cell);
    }
    return out;
  };
}

/// When a cell is good enough.
struct PreprocessOptions {
  std::uint64_t budget = 0;  ///< a cell that sees more polygons is divided
  double min_size = 1;       ///< but not into cells with a longest extent of less than this, in metres; > 0
};

/// A cell that is not divided further.
struct LeafCell {
  ViewCell cell;
  std::uint32_t initial;   ///< position of the initial cell that it is a part of
  std::uint64_t polygons;  ///< that it sees
  CellSet set;
};

struct PreprocessedCells {
  std::vector<LeafCell> leaves;  ///< by initial cell, parts of a cell side by side
  std::size_t evaluated = 0;     ///< cells that the method was asked about
  double seconds = 0;            ///< all of its answers took, added up
};

/// The adaptive preprocess of [Durand00, 6.1]: a set for each initial cell; a cell that sees more polygons than the
/// budget is cut in two (halves()), whose sets start from its own: what is hidden from a cell is hidden from its parts.
/// So the set of a leaf is conservative, or exact where the method is; it is within that of its parent. A polytope is
/// replaced by divisible(cell); the leaves of an initial cell cover it.
/// `polygons`: of each object. Initial cells run in parallel (oneTBB), and so do the parts of one; the result does not
/// depend on the number of threads. `done` is told of finished initial cells, from any thread. Throws
/// std::invalid_argument if the smallest size is not positive, or if a set is neither exact nor conservative: what such
/// a set lacks may be visible from a part. What the query throws is thrown here.
PreprocessedCells preprocess(
  CellQuery const& query, std::span<ViewCell const> initial, std::span<std::uint64_t const> polygons,
  PreprocessOptions const& options, std::function<void()> const& done = [] {});

}  // namespace visibility
