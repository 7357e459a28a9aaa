#pragma once

#include "visibility/scene/convex_cover.hpp"
#include "visibility/scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace visibility {

/// A convex body inside an object: whatever it blocks, the object's own primitives block.
///
/// For a view cell that satisfies both conditions below, a half-open sight line [p, s) from the interior of the cell
/// that meets the closed body meets a primitive of the object: an additional occluder, which changes nothing that is
/// true. Other cells: Occluders::blocks_beyond_owner alone.
struct InnerBody {
  std::variant<ConvexPrism, ConvexPolyhedron> shape;
  double floor = 0;  ///< the cell must lie in z >= floor; -infinity if the object encloses the body from below
  bool needs_outside = false;  ///< the cell must not meet the object's bounding box
};

/// What the search for inner bodies may cost and give.
struct InnerBodyOptions {
  std::size_t max_bodies = 8;         ///< of an object; those of the largest side view are kept
  std::size_t max_triangles = 5'000;  ///< connected meshes with more are skipped
  std::size_t slices = 6;             ///< horizontal sections of a mesh that are tried
  std::size_t pieces_per_slice = 12;  ///< convex polygons tried in a section
  std::size_t max_corners = 24;       ///< of a prism's footprint; a roof may add as many again
  bool roofs = true;                  ///< try hulls of a prism with what stands on it
  bool shells = true;                 ///< a PreparedScene keeps the shells too, for slices (EnclosingShells)
};

/// Convex bodies inside one object, largest side view first: of its prisms, overlapping convex pieces of the footprint;
/// of its loose triangles, prisms and hulls inside what they enclose. `loose_triangles` are positions in
/// `scene.triangles`; those that bound convex solids need no inner bodies and may be left out.
///
/// The search is free and rounded, the certificate exact (proofs/inner_bodies.md): triangles enclose what they
/// separate, modulo 2, from the outside, seen from above a floor below which they may be open. What cannot be certified
/// is not returned; a mesh with a missing wall has no inner bodies.
std::vector<InnerBody> inner_bodies(Scene const& scene, Object const& object,
                                    std::span<std::uint32_t const> loose_triangles,
                                    InnerBodyOptions const& options = {});

Box bounding_box(InnerBody const& body);

/// Whether the body may be used as an occluder for cells within `cell`; `object` is the bounding box of its object.
inline bool may_occlude(InnerBody const& body, Box const& cell, Box const& object)
{
  return cell.min.z >= body.floor && !(body.needs_outside && meet(cell, object));
}

}  // namespace visibility
