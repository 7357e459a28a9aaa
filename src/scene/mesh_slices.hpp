#pragma once

#include "mesh_shells.hpp"
#include "plan.hpp"

namespace visibility::detail {

/// Heights at which to cut the shell, above its floor: the middles of the largest gaps between vertex heights, at most
/// `most`, ascending.
std::vector<double> slice_heights(MeshShell const& shell, std::size_t most);

/// The shell's section at a height that no vertex has: rings, rounded, without corners that are straight up to `slack`.
/// On vertical walls their corners are exact. Open ends (of edges that fit only after cutting) are joined to the
/// nearest one. Nothing that depends on it is decided by it.
std::vector<plan::Polygon> slice(MeshShell const& shell, double z, double slack);

/// Rings as polygons with holes: each outer ring with the rings directly inside it. Rounded.
std::vector<std::vector<plan::Polygon>> nested(std::vector<plan::Polygon> rings);

}  // namespace visibility::detail
