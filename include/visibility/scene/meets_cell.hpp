#pragma once

#include "visibility/scene/prepared_scene.hpp"
#include "visibility/scene/view_cell.hpp"

namespace visibility {

/// Whether the object meets the closed cell, which makes it visible without a witness. Exact.
bool meets_cell(PreparedScene const& scene, ViewCell const& cell, std::uint32_t object);

}  // namespace visibility
