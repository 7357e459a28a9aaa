#pragma once

#include "visibility/scene/result_file.hpp"
#include "visibility/viewspace/delta_sets.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace visibility {

/// What a file of format "visibility-sets/1" holds: the sets of many cells, and what is needed to read them without the
/// scene. docs/result-format.md describes the bytes.
struct StoredSets {
  Result about;                         ///< of all cells; without cell, visible and witnesses
  std::vector<std::string> names;       ///< of the objects
  std::vector<std::uint64_t> polygons;  ///< of each object
  std::vector<std::uint32_t> initial;   ///< of each cell the initial cell that it is a part of
  DeltaSets sets;

  /// The result for one cell, as `pvs` gives it. Requires: cell < sets.size().
  Result result(std::size_t cell) const { return result(cell, sets.set(cell)); }
  /// The same, its set being known.
  Result result(std::size_t cell, DeltaSets::Objects const& visible) const;
};

/// Bytes of the sets in the file, and if each were stored as a whole in the same coding.
struct StoredSizes {
  std::size_t differences = 0, whole = 0;
};
StoredSizes stored_sizes(DeltaSets const& sets);

/// The bytes of a file. Requires: one name and count for each object, one initial cell for each cell.
std::string to_bytes(StoredSets const& stored);
/// Throws BadInput with `name` if the bytes are not those of a whole, undamaged file.
StoredSets stored_sets_from_bytes(std::string_view bytes, std::string const& name);
StoredSets read_stored_sets(std::filesystem::path const& file);

}  // namespace visibility
