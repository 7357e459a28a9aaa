#pragma once

#include "mesh_shells.hpp"

namespace visibility::detail {

/// Whether the body is certainly one that the shell blocks for (proofs/inner_bodies.md): it lies above the shell's
/// floor, no facet meets its open interior, and a point of that is enclosed. Exact; `false` also if the rounded mean of
/// the corners is not strictly inside the body.
bool is_certified(MeshShell const& shell, ConvexPrism const& body);
bool is_certified(MeshShell const& shell, ConvexPolyhedron const& body);

}  // namespace visibility::detail
