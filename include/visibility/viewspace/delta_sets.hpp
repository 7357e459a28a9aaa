#pragma once

#include "visibility/scene/bounding_hierarchy.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace visibility {

/// The sets of many cells, stored as differences: key cells have their whole set, each other one what is to be added to
/// or taken from the set of a neighbour. Which cells are keys, and which neighbour serves, is chosen so that the bytes
/// are fewest among the pairs of neighbours(): a minimum spanning forest. Every set is recovered exactly.
/// Source: the delta-PVS of [Durand00, 6.1].
class DeltaSets {
public:
  using Objects = std::vector<std::uint32_t>;  ///< ascending

  /// How one set is stored.
  struct Entry {
    static constexpr std::uint32_t key = UINT32_MAX;
    std::uint32_t from = key;  ///< the cell whose set differs by `changed`; key: none, as if it were empty
    Objects changed;           ///< objects that are in one of both sets
    friend bool operator==(Entry const&, Entry const&) = default;
  };

  /// Stores one set for each cell. Throws std::invalid_argument if there is not one for each, or if one is not
  /// ascending or names an object that is not there.
  DeltaSets(std::vector<ViewCell> cells, std::span<Objects const> sets, std::uint32_t objects);
  /// From entries as they were stored. Throws std::invalid_argument as above, or if entries refer to each other in a
  /// circle.
  DeltaSets(std::vector<ViewCell> cells, std::vector<Entry> entries, std::uint32_t objects);

  std::size_t size() const { return cells_.size(); }
  std::uint32_t object_count() const { return objects_; }
  std::span<ViewCell const> cells() const { return cells_; }
  std::span<Entry const> entries() const { return entries_; }
  std::size_t key_count() const;

  /// The set of a cell. Requires: cell < size().
  Objects set(std::size_t cell) const;
  /// The sets of all cells, each made from its neighbour's; in one walk.
  std::vector<Objects> all() const;
  /// The first cell that contains the point, on its boundary too. Exact.
  std::optional<std::size_t> cell_at(Point3d const& point) const;

private:
  void validate() const;

  std::vector<ViewCell> cells_;
  std::vector<Entry> entries_;
  std::uint32_t objects_;
  BoundingHierarchy hierarchy_;
};

/// Bytes that numbers take in a file: 7 bits to a byte.
std::size_t encoded_size(std::uint64_t number);
/// Bytes of an ascending list: its length, its first member, the gaps.
std::size_t encoded_size(std::span<std::uint32_t const> ascending);

}  // namespace visibility
