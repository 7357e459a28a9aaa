#pragma once

#include "visibility/scene/object_selection.hpp"
#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <vector>

namespace visibility::extended_projection {

/// How large a box is seen from the middle of the cell, in pixels of a map of so many: about. A choice.
double approximate_pixels(Box const& box, ViewCell const& cell, int resolution);

/// Positions of the occluders of an object that are worth projecting: all, but where convex bodies inside the object
/// block from the cell the largest of these, in place of its single triangles. A choice.
IndexRange worthwhile_occluders(PreparedScene const& scene, ViewCell const& cell, std::uint32_t object);

/// Whether the occluder blocks from the cell.
bool blocks(PreparedScene const& scene, ViewCell const& cell, std::uint32_t occluder);

/// The occluders of the largest solid angle as seen from the middle of the cell, the largest first: about, by surfaces
/// of boxes and squared distances, best first through the hierarchy [Durand00, 6.1]. Fewer if the scene has fewer.
/// A choice. Only worthwhile ones, which block from the cell; only those of `among`, if it is given.
std::vector<std::uint32_t> select_occluders(PreparedScene const& scene, ViewCell const& cell, std::size_t count,
                                            ObjectSelection const* among = nullptr);

}  // namespace visibility::extended_projection
