#pragma once

#include <cstdint>
#include <string>

namespace visibility {

/// Half-open range of indices into one of a scene's primitive arrays.
struct IndexRange {
  std::uint32_t first = 0, last = 0;
  std::uint32_t size() const { return last - first; }
};

/// What a visibility query names: a building, a tree, a ball. Its primitives are contiguous in each array.
struct Object {
  std::string name;
  IndexRange boxes, balls, prisms, polyhedra, triangles;
  bool occludes = true;  ///< false: only looked for, such as the region where something may move; hides nothing
};

}  // namespace visibility
