#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/kernel/point.hpp"
#include "visibility/scene/convex_bodies.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// Facets of one object that enclose a solid, convex or not, above `floor`: for slices by planes. A sight line from z
/// >= floor, out of the bounds, to a point z > floor that is enclosed modulo 2 meets a facet no later
/// (proofs/inner_bodies.md, "Shells"). Orientation means nothing.
struct EnclosingShell {
  std::vector<Point3d> vertices;  ///< of distinct positions
  /// Facets, triangles, one after the other: the vertices around each, those that other facets have on its sides too.
  /// So every side, a pair of neighbours in a facet, is used an even number of times unless it lies in z <= floor.
  std::vector<std::uint32_t> around;
  std::vector<std::uint32_t> first_of_facet;  ///< and the size of `around` at the end
  Box bounds;
  double floor;  ///< -infinity if all sides are even
  std::uint32_t object;

  std::size_t facets() const { return first_of_facet.size() - 1; }
  std::span<std::uint32_t const> facet(std::size_t f) const
  {
    return std::span(around).subspan(first_of_facet[f], first_of_facet[f + 1] - first_of_facet[f]);
  }
};

/// The enclosing shells of a scene, by object: those of objects that occlude and have triangles that are not parts of
/// convex solids.
class EnclosingShells {
public:
  EnclosingShells() = default;
  /// Connected meshes of more than `most_facets` triangles are left out.
  EnclosingShells(ConvexBodies const& bodies, std::size_t most_facets);

  std::size_t size() const { return shells_.size(); }
  std::span<EnclosingShell const> of_object(std::uint32_t object) const
  {
    if (shells_.empty()) return {};
    return std::span(shells_).subspan(first_of_object_[object],
                                      first_of_object_[object + 1] - first_of_object_[object]);
  }

private:
  std::vector<EnclosingShell> shells_;
  std::vector<std::uint32_t> first_of_object_;
};

}  // namespace visibility
