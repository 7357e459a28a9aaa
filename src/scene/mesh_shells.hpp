#pragma once

#include "visibility/scene/scene.hpp"

#include <array>
#include <span>
#include <vector>

namespace visibility::detail {

/// Triangles of one object that enclose a solid above `floor`: a cycle modulo 2 in the open half-space z > floor, that
/// is, every edge, cut where another ends on it, is used an even number of times unless it lies in z <= floor
/// (proofs/inner_bodies.md). Vertices have distinct positions; no facet is degenerate; orientation means nothing.
struct MeshShell {
  std::vector<Point3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> facets;
  Box bounds;
  double floor;  ///< -infinity if the shell is closed

  Triangle triangle(std::size_t f) const
  {
    auto const& t = facets[f];
    return {{vertices[t[0]], vertices[t[1]], vertices[t[2]]}};
  }
};

/// The shells in these triangles: components connected through edges of two triangles, joined where an open end of one
/// fits another's. Components whose floor is their top enclose nothing and are left out, and so are those of more than
/// `most_facets` triangles.
std::vector<MeshShell> mesh_shells(Scene const& scene, std::span<std::uint32_t const> triangles,
                                   std::size_t most_facets);

/// Open sides beyond this number are not cut: the search is quadratic.
inline constexpr std::size_t most_open_sides = 2'000;

/// Those of `ends` that lie on the side from vertex `first` to vertex `last`, strictly between them, in order. Exact.
/// Requires: vertices in lexicographic order, ends ascending, first < last.
std::vector<std::uint32_t> vertices_on_side(std::span<Point3d const> vertices, std::span<std::uint32_t const> ends,
                                            std::uint32_t first, std::uint32_t last);

/// Whether a ray from p, upward and infinitesimally aside, crosses the shell an odd number of times. Exact.
/// Requires: p lies on no facet.
bool encloses(MeshShell const& shell, Point3d const& p);

}  // namespace visibility::detail
