#include "visibility/viewspace/preprocess.hpp"

#include "visibility/viewspace/divide.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <stdexcept>

namespace visibility {

namespace {

/// The leaves of one initial cell.
class Division {
public:
  Division(CellQuery const& query, std::uint32_t initial, std::span<std::uint64_t const> polygons,
           PreprocessOptions const& options)
    : query_(query), initial_(initial), polygons_(polygons), options_(options)
  {
  }

  PreprocessedCells of(ViewCell const& cell, ParentCell const* parent) const
  {
    auto const start = std::chrono::steady_clock::now();
    auto [set, left] = query_(cell, parent);
    if (set.guarantee != Guarantee::exact && set.guarantee != Guarantee::conservative)
      throw std::invalid_argument("a set that may lack visible objects cannot be divided");
    if (parent != nullptr) keep(set, parent->visible);
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    std::uint64_t seen = 0;
    for (auto const o : set.visible) seen += polygons_[o];
    auto const parts = seen > options_.budget && longest_extent(cell) / 2 >= options_.min_size
                         ? halves(cell)
                         : std::optional<std::pair<ViewCell, ViewCell>>();
    PreprocessedCells out;
    if (!parts) {
      out.leaves.push_back({cell, initial_, seen, {std::move(set), seconds}});
    } else {
      ParentCell const here{set.visible, std::move(left)};
      PreprocessedCells second;
      oneapi::tbb::parallel_invoke([&] { out = of(parts->first, &here); }, [&] { second = of(parts->second, &here); });
      append(out, std::move(second));
    }
    ++out.evaluated;
    out.seconds += seconds;
    return out;
  }

  static void append(PreprocessedCells& to, PreprocessedCells from)
  {
    std::ranges::move(from.leaves, std::back_inserter(to.leaves));
    to.evaluated += from.evaluated;
    to.seconds += from.seconds;
  }

private:
  /// Takes out what is hidden from the parent.
  static void keep(PotentiallyVisibleSet& set, std::span<std::uint32_t const> visible)
  {
    auto const is_hidden = [&](std::uint32_t o) { return !std::ranges::binary_search(visible, o); };
    std::erase_if(set.visible, is_hidden);
    std::erase_if(set.witnesses, [&](Witness const& w) { return is_hidden(w.object); });
  }

  CellQuery const& query_;
  std::uint32_t initial_;
  std::span<std::uint64_t const> polygons_;
  PreprocessOptions const& options_;
};

}  // namespace

PreprocessedCells preprocess(CellQuery const& query, std::span<ViewCell const> initial,
                             std::span<std::uint64_t const> polygons, PreprocessOptions const& options,
                             std::function<void()> const& done)
{
  if (!(options.min_size > 0)) throw std::invalid_argument("the smallest size of a cell must be positive");
  std::vector<PreprocessedCells> parts(initial.size());
  oneapi::tbb::parallel_for(std::size_t{0}, initial.size(), [&](std::size_t i) {
    parts[i] = Division(query, static_cast<std::uint32_t>(i), polygons, options).of(divisible(initial[i]), nullptr);
    done();
  });
  PreprocessedCells out;
  for (auto& p : parts) Division::append(out, std::move(p));
  return out;
}

}  // namespace visibility
