#pragma once

#include "visibility/drawing/plan_picture.hpp"
#include "visibility/scene/result_file.hpp"

#include <span>
#include <vector>

namespace visibility::commands {

/// Up to `most` witnesses of a result, spread over directions.
std::vector<PlanPicture::Segment> sight_lines_of(Result const& result, std::size_t most);

/// Sight lines to up to `most` of the visible objects, spread over directions, found by guided rays and confirmed
/// exactly; fewer if rays do not find so many soon. `occludees`: where the objects are of another scene.
std::vector<PlanPicture::Segment> find_sight_lines(Scene const& scene, PreparedScene const* occludees,
                                                   ViewCell const& cell, std::span<std::uint32_t const> visible,
                                                   std::size_t most);

}  // namespace visibility::commands
