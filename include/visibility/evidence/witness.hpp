#pragma once

#include "visibility/evidence/face.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/view_cell.hpp"

namespace visibility {

/// Whether the witness proves what it says: `from` in the cell's interior, `to` in the relative interior of a face of
/// the object, and no occluder met before `to`. Exact, with rationals alone; anyone's witness may be given.
/// A witness whose ends coincide proves nothing.
bool confirm(PreparedScene const& scene, ViewCell const& cell, Witness const& witness);

/// A sight line as floating-point rays propose it.
struct Candidate {
  std::uint32_t object;
  Face face;     ///< of that object
  Point3d from;  ///< in the interior of the cell
  Point3d near;  ///< where the line meets the face, rounded
};

/// A proved witness near the proposed line: the end is moved into the face's relative interior, towards its middle if
/// the first try is blocked. Empty: none of a few lines is free. Exact (filtered where the target is a double).
/// Requires: in_interior(cell, candidate.from).
std::optional<Witness> find_witness(PreparedScene const& scene, Candidate const& candidate);

}  // namespace visibility
