#pragma once

#include "mesh_shells.hpp"

#include "visibility/scene/inner_bodies.hpp"

namespace visibility::detail {

/// Certified vertical prisms inside the shell: in each of some horizontal sections, convex polygons grown from a convex
/// partition, each extended up and down until a facet stops it. A prism is left out if an earlier one contains its
/// polygon at the height of its section.
std::vector<ConvexPrism> inner_prisms(MeshShell const& shell, InnerBodyOptions const& options);

}  // namespace visibility::detail
