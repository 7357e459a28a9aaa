#pragma once

#include <cstdint>

namespace visibility::strong_occlusion {

/// What a run did; the paper measures cost in rays.
struct Counts {
  std::uint64_t targets = 0;     ///< boxes, parts and faces for which an occluder was sought
  std::uint64_t candidates = 0;  ///< occluders whose rays were tested
  std::uint64_t rays = 0;        ///< sight lines tested against a candidate, exactly
  std::uint64_t probes = 0;      ///< bounding boxes tested, to find candidates
  std::uint64_t face_rays = 0;   ///< the part of `rays` that went to faces and triangles
};

}  // namespace visibility::strong_occlusion
