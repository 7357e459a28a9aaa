#pragma once

#include "visibility/geometry/box.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// Closed convex polyhedron with interior, its boundary triangulated.
/// Invariants (`validate`): a closed 2-manifold of genus 0; every vertex lies on the inner side of, or on, the plane of
/// every facet; no facet is degenerate; facets are counterclockwise seen from outside.
struct ConvexPolyhedron {
  using Index = std::uint32_t;
  /// An edge of the boundary; `from < to`.
  struct Edge {
    Index from, to;
  };
  /// A triangle of the boundary. `edges[i]` runs from vertices[i] to vertices[(i+1)%3]; ~e means edge e reversed.
  struct Facet {
    std::array<Index, 3> vertices;
    std::array<std::int32_t, 3> edges;
  };

  std::vector<Point3d> vertices;
  std::vector<Edge> edges;
  std::vector<Facet> facets;

  /// The polyhedron with these facets (vertex triples, outward counterclockwise).
  /// Throws std::invalid_argument if the invariants do not hold; then the mesh is not a convex polyhedron.
  static ConvexPolyhedron from_facets(std::vector<Point3d> vertices, std::span<std::array<Index, 3> const> facets);

  /// Convex hull, exactly decided; keeps only extreme points, bit for bit.
  /// Throws std::invalid_argument if the points are not finite or all lie in one plane.
  static ConvexPolyhedron hull(std::span<Point3d const> points);

  static ConvexPolyhedron from_box(Box const& box);  ///< Requires: box.has_interior()

  void validate() const;  ///< throws std::logic_error naming the broken invariant
};

inline Box bounding_box(ConvexPolyhedron const& p)
{
  Box b;
  for (auto const& v : p.vertices) b.extend(v);
  return b;
}

}  // namespace visibility
