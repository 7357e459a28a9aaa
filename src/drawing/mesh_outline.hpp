#pragma once

#include "visibility/scene/scene.hpp"

#include <vector>

namespace visibility::detail {

/// Rings that wind around exactly the points which the triangles cover in plan; upright triangles cover none.
std::vector<std::vector<Point2d>> mesh_outline(Scene const& scene, IndexRange triangles);

}  // namespace visibility::detail
