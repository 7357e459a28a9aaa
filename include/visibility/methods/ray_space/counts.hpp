#pragma once

#include <cstdint>

namespace visibility::ray_space {

/// What a run did.
struct Counts {
  std::uint64_t nodes = 0;            ///< of the hierarchy, tested
  std::uint64_t objects = 0;          ///< tested
  std::uint64_t parts = 0;            ///< bodies and triangles tested
  std::uint64_t occluders = 0;        ///< bodies entered into the maps
  std::uint64_t pixels = 0;           ///< gates entered
  std::uint64_t parts_of_pixels = 0;  ///< made
};

}  // namespace visibility::ray_space
