#include "mesh_pieces.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <stdexcept>

namespace visibility::detail {

namespace {

using Index = std::uint32_t;
using Triple = std::array<Index, 3>;

/// The triangles over welded vertices; degenerate ones are left out.
struct Welded {
  std::vector<Point3d> vertices;
  std::vector<Triple> facets;
  std::vector<Index> origin;  ///< position in scene.triangles
};

Welded weld(Scene const& scene, IndexRange range)
{
  Welded w;
  for (auto i = range.first; i < range.last; ++i)
    for (auto const v : scene.triangles[i]) w.vertices.push_back(scene.vertices[v]);
  auto const less = [](Point3d const& a, Point3d const& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::ranges::sort(w.vertices, less);
  w.vertices.erase(std::unique(w.vertices.begin(), w.vertices.end()), w.vertices.end());
  auto const find = [&](Point3d const& p) {
    return static_cast<Index>(std::ranges::lower_bound(w.vertices, p, less) - w.vertices.begin());
  };
  for (auto i = range.first; i < range.last; ++i) {
    auto const& t = scene.triangles[i];
    Triple const f{find(scene.vertices[t[0]]), find(scene.vertices[t[1]]), find(scene.vertices[t[2]])};
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
    w.facets.push_back(f);
    w.origin.push_back(i);
  }
  return w;
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

/// The facets as a convex polyhedron, turned outward; empty if they do not bound one.
std::vector<ConvexPolyhedron> as_convex(std::vector<Point3d> const& all, std::span<Triple const> facets)
{
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
    for (std::size_t i = 0; i < 3; ++i)
      t[i] = static_cast<Index>(std::ranges::lower_bound(used, f[i]) - used.begin());
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

}  // namespace

MeshPieces mesh_pieces(Scene const& scene, IndexRange range)
{
  MeshPieces out;
  Welded const mesh = weld(scene, range);
  auto const component = components(mesh.facets);
  std::vector<Index> order(mesh.facets.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, {}, [&](Index f) { return component[f]; });
  std::vector<bool> solid(scene.triangles.empty() ? 0 : range.size(), false);
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    std::vector<Triple> facets;
    for (; last < order.size() && component[order[last]] == component[order[first]]; ++last)
      facets.push_back(mesh.facets[order[last]]);
    if (auto piece = as_convex(mesh.vertices, facets); !piece.empty()) {
      out.convex.push_back(std::move(piece.front()));
      for (; first < last; ++first) solid[mesh.origin[order[first]] - range.first] = true;
    }
    first = last;
  }
  for (auto i = range.first; i < range.last; ++i)
    if (!solid[i - range.first]) out.loose.push_back(i);
  return out;
}

}  // namespace visibility::detail
