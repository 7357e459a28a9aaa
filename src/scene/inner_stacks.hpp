#pragma once

#include "visibility/scene/inner_bodies.hpp"

#include <span>

namespace visibility::detail {

/// Prisms that are unions of parts of several certified prisms of one object, on top of each other: over each
/// footprint, as far as prisms whose footprints contain it (exactly) touch or overlap in height. A prism is joined only
/// to those that serve all cells it serves. Storeys that are solids of their own become one tower.
std::vector<InnerBody> stacks(std::span<InnerBody const> bodies);

}  // namespace visibility::detail
