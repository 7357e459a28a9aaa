#pragma once

#include "visibility/methods/extended_projection/frame.hpp"
#include "visibility/raster/contours.hpp"
#include "visibility/scene/enclosing_shells.hpp"

#include <optional>
#include <vector>

namespace visibility::extended_projection {

/// The ground, z = level, below which no sight line passes, and how far down solids on it are carried on.
struct Ground {
  double level, deep;
};

/// The section of what a shell encloses with a plane w = at of a frame, by the even-odd rule: the limit of those from
/// w < at, so that a solid that ends there has one.
struct ShellSlice {
  double at;                       ///< in a turned frame a hair less than what was asked for
  std::vector<ContourEdge> edges;  ///< (u, v); in v > low all ends are even
  double error;                    ///< of each coordinate of each point
  double low;                      ///< pixels that reach below v = low do not count
};

/// The section at w = `at`. `ground`: what stands on it is carried down, in frames with a vertical v; may be null. None
/// if there is none above the shell's floor, or rounding is in the way.
std::optional<ShellSlice> slice(EnclosingShell const& shell, Frame const& frame, double at, Ground const* ground);

}  // namespace visibility::extended_projection
