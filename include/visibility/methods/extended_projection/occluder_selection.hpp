#pragma once

#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <vector>

namespace visibility::extended_projection {

/// The occluders of the largest solid angle as seen from the middle of the cell, the largest first: about, by surfaces
/// of boxes and squared distances, best first through the hierarchy [Durand00, 6.1]. Fewer if the scene has fewer.
/// A choice. Only such as block from the cell.
std::vector<std::uint32_t> select_occluders(PreparedScene const& scene, ViewCell const& cell, std::size_t count);

}  // namespace visibility::extended_projection
