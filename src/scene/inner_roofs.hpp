#pragma once

#include "mesh_shells.hpp"

#include <optional>
#include <span>

namespace visibility::detail {

/// A certified hull of the prism and of what stands on it: of the shell's vertices above it, or of a higher one of the
/// other prisms; of at most `most_corners` points on top. Nothing if the shell does not rise above the prism or no such
/// hull is inside.
std::optional<ConvexPolyhedron> with_roof(MeshShell const& shell, ConvexPrism const& prism,
                                          std::span<ConvexPrism const> others, std::size_t most_corners);

}  // namespace visibility::detail
