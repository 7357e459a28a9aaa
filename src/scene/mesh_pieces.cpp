#include "mesh_pieces.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <span>
#include <stdexcept>
#include <tuple>

namespace visibility::detail {

namespace {

using Index = std::uint32_t;
using Triple = std::array<Index, 3>;

/// What counts as one vertex.
enum class Identity { index, position };

/// Triangles over vertices of their own; degenerate ones are left out.
struct Mesh {
  std::vector<Point3d> vertices;
  std::vector<Triple> facets;
  std::vector<Index> origin;  ///< position in scene.triangles
};

Mesh extract(Scene const& scene, std::vector<Index> const& triangles, Identity identity)
{
  auto const less = [&](Index a, Index b) {
    if (identity == Identity::index) return a < b;
    Point3d const &p = scene.vertices[a], &q = scene.vertices[b];
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  std::vector<Index> used;
  for (auto const i : triangles) used.insert(used.end(), scene.triangles[i].begin(), scene.triangles[i].end());
  std::ranges::sort(used, less);
  auto const same = [&](Index a, Index b) { return !less(a, b) && !less(b, a); };
  used.erase(std::unique(used.begin(), used.end(), same), used.end());
  Mesh mesh;
  for (auto const v : used) mesh.vertices.push_back(scene.vertices[v]);
  for (auto const i : triangles) {
    Triple f{};
    std::ranges::transform(scene.triangles[i], f.begin(), [&](Index v) {
      return static_cast<Index>(std::ranges::lower_bound(used, v, less) - used.begin());
    });
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
    mesh.facets.push_back(f);
    mesh.origin.push_back(i);
  }
  return mesh;
}

/// Component of each facet: facets that share an edge are in one.
std::vector<Index> components(std::vector<Triple> const& facets)
{
  struct Side {
    Index a, b, facet;
  };
  std::vector<Side> sides;
  for (Index f = 0; f < facets.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      auto const [a, b] = std::minmax(facets[f][i], facets[f][(i + 1) % 3]);
      sides.push_back({a, b, f});
    }
  std::ranges::sort(sides, {}, [](Side const& s) { return std::pair(s.a, s.b); });
  std::vector<Index> parent(facets.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  auto const find = [&](Index i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].a == sides[i - 1].a && sides[i].b == sides[i - 1].b)
      parent[find(sides[i].facet)] = find(sides[i - 1].facet);
  for (Index i = 0; i < parent.size(); ++i) parent[i] = find(i);
  return parent;
}

/// Larger components stay loose: proving one convex takes facets x vertices tests, and every sight line as many.
constexpr std::size_t most_facets = 5'000;

/// The facets as a convex polyhedron, turned outward; empty if they do not bound one.
std::vector<ConvexPolyhedron> as_convex(std::vector<Point3d> const& all, std::span<Triple const> facets)
{
  if (facets.size() > most_facets) return {};
  std::vector<Index> used;
  for (auto const& f : facets) used.insert(used.end(), f.begin(), f.end());
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  if (used.size() * 2 != facets.size() + 4) return {};  // Euler, for a triangulated sphere
  std::vector<Point3d> vertices;
  for (auto const v : used) vertices.push_back(all[v]);
  std::vector<Triple> local;
  for (auto const& f : facets) {
    Triple t{};
    for (std::size_t i = 0; i < 3; ++i) t[i] = static_cast<Index>(std::ranges::lower_bound(used, f[i]) - used.begin());
    local.push_back(t);
  }
  // One vertex off the first facet's plane tells which way the facets face.
  auto const& [a, b, c] = local.front();
  for (auto const& v : vertices) {
    Sign const s = orient3d<Filtered>(vertices[a], vertices[b], vertices[c], v);
    if (is_zero(s)) continue;
    if (is_positive(s))
      for (auto& t : local) std::swap(t[1], t[2]);
    break;
  }
  try {
    return {ConvexPolyhedron::from_facets(std::move(vertices), local)};
  } catch (std::invalid_argument const&) {
    return {};
  }
}

/// Moves the convex components of these triangles to `convex`; returns the triangles that belong to none, ascending.
std::vector<Index> take_convex(Scene const& scene, std::vector<Index> const& triangles, Identity identity,
                               std::vector<ConvexPolyhedron>& convex)
{
  Mesh const mesh = extract(scene, triangles, identity);
  auto const component = components(mesh.facets);
  std::vector<Index> order(mesh.facets.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, {}, [&](Index f) { return component[f]; });
  std::vector<Index> solid;
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    std::vector<Triple> facets;
    for (; last < order.size() && component[order[last]] == component[order[first]]; ++last)
      facets.push_back(mesh.facets[order[last]]);
    if (auto piece = as_convex(mesh.vertices, facets); !piece.empty()) {
      convex.push_back(std::move(piece.front()));
      for (auto i = first; i < last; ++i) solid.push_back(mesh.origin[order[i]]);
    }
    first = last;
  }
  std::ranges::sort(solid);
  std::vector<Index> loose;
  std::ranges::set_difference(triangles, solid, std::back_inserter(loose));
  return loose;
}

}  // namespace

MeshPieces mesh_pieces(Scene const& scene, IndexRange range)
{
  MeshPieces out;
  out.loose.resize(range.size());
  std::iota(out.loose.begin(), out.loose.end(), range.first);
  // By index first: solids that touch along an edge have distinct vertices there. Then by position: files often give
  // each face its own vertices.
  out.loose = take_convex(scene, out.loose, Identity::index, out.convex);
  if (!out.loose.empty()) out.loose = take_convex(scene, out.loose, Identity::position, out.convex);
  return out;
}

}  // namespace visibility::detail
