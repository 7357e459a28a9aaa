#pragma once

#include "visibility/evidence/check.hpp"
#include "visibility/scene/occludees.hpp"

namespace visibility {

/// The same hunt for occludees that are apart from the occluders: rays from the cell to points of the pieces of those
/// that the set lacks, each in turn. Simpler than `check`: rays are not guided, and `unseen` and `objects_seen` stay
/// empty. One thread. Throws std::invalid_argument if `visible` names an occludee that is not there.
CheckReport check(RayScene const& occluders, Occludees const& occludees, ViewCell const& cell,
                  std::span<std::uint32_t const> visible, Guarantee claimed, CheckOptions const& options = {});

}  // namespace visibility
