#pragma once

#include "visibility/scene/scene.hpp"

#include <cstddef>

namespace visibility {

/// Harmless oddities of a scene, counted exactly.
struct SceneReport {
  std::size_t zero_area_triangles = 0;  ///< the three vertices are collinear
  std::size_t duplicate_faces = 0;      ///< triangles whose vertices, in any order, an earlier triangle has
  std::size_t flat_boxes = 0;           ///< boxes without interior
};

/// O(n log n) in the number of triangles.
SceneReport report(Scene const& scene);

}  // namespace visibility
