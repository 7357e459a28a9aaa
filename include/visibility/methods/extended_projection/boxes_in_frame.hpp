#pragma once

#include "visibility/methods/extended_projection/frame.hpp"
#include "visibility/scene/prepared_scene.hpp"

#include <cstdint>

namespace visibility::extended_projection {

/// Objects of more bodies are looked at as a whole only.
inline constexpr std::size_t most_occludee_bodies = ObjectOutlines::few_bodies;

/// A box in the frame that contains the body: in a turned frame that of its vertices, which is smaller than that of its
/// bounds. `body`: a position in ConvexBodies::bodies().
Box body_box(ConvexBodies const& bodies, std::size_t body, Frame const& frame);
/// The same for an occluder, a position in Occluders.
Box occluder_box(Occluders const& occluders, std::uint32_t occluder, Frame const& frame);
/// The same for an object; of one of more bodies, of the prism over its outline.
Box object_box(PreparedScene const& scene, std::uint32_t object, Frame const& frame);

}  // namespace visibility::extended_projection
