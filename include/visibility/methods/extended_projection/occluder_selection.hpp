#pragma once

#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <vector>

namespace visibility::extended_projection {

/// How large a box is seen from the middle of the cell, in pixels of a map of so many: about. A choice.
double approximate_pixels(Box const& box, ViewCell const& cell, int resolution);

/// Whether the occluder blocks from the cell, and is not a single triangle of an object that has convex bodies inside
/// which do. The second part is a choice.
bool is_useful(PreparedScene const& scene, ViewCell const& cell, std::uint32_t occluder);

/// The occluders of the largest solid angle as seen from the middle of the cell, the largest first: about, by surfaces
/// of boxes and squared distances, best first through the hierarchy [Durand00, 6.1]. Fewer if the scene has fewer.
/// A choice. Only useful ones.
std::vector<std::uint32_t> select_occluders(PreparedScene const& scene, ViewCell const& cell, std::size_t count);

}  // namespace visibility::extended_projection
