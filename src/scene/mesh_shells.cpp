#include "mesh_shells.hpp"

#include "visibility/geometry/segment_coplanar.hpp"
#include "visibility/kernel/arithmetic.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace visibility::detail {

namespace {

using Index = std::uint32_t;
using Triple = std::array<Index, 3>;

/// Union-find over facets.
class Components {
public:
  explicit Components(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index find(Index i)
  {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) { parent_[find(a)] = find(b); }

private:
  std::vector<Index> parent_;
};

/// Vertices in lexicographic order of position, so that a < b in index means before in space; facets without those that
/// are degenerate or that occur an even number of times.
struct Welded {
  std::vector<Point3d> vertices;
  std::vector<Triple> facets;
};

Welded weld(Scene const& scene, std::span<Index const> triangles)
{
  auto const key = [&](Index v) {
    Point3d const& p = scene.vertices[v];
    return std::tie(p.x, p.y, p.z);
  };
  auto const less = [&](Index a, Index b) { return key(a) < key(b); };
  std::vector<Index> used;
  for (auto const i : triangles) used.insert(used.end(), scene.triangles[i].begin(), scene.triangles[i].end());
  std::ranges::sort(used, less);
  used.erase(std::unique(used.begin(), used.end(), [&](Index a, Index b) { return key(a) == key(b); }), used.end());
  Welded out;
  for (auto const v : used) out.vertices.push_back(scene.vertices[v]);
  for (auto const i : triangles) {
    Triple f{};
    std::ranges::transform(scene.triangles[i], f.begin(), [&](Index v) {
      return static_cast<Index>(std::ranges::lower_bound(used, v, less) - used.begin());
    });
    std::ranges::sort(f);
    auto const& v = out.vertices;
    if (projection_axis<Filtered>(v[f[0]], v[f[1]], v[f[2]]) >= 0) out.facets.push_back(f);
  }
  std::ranges::sort(out.facets);
  std::size_t kept = 0;
  for (std::size_t i = 0, j = 0; i < out.facets.size(); i = j) {
    while (j < out.facets.size() && out.facets[j] == out.facets[i]) ++j;
    if ((j - i) % 2 == 1) out.facets[kept++] = out.facets[i];
  }
  out.facets.resize(kept);
  return out;
}

/// An edge from the lexicographically smaller vertex, and a facet at it.
struct Side {
  Index a, b, facet;
  auto edge() const { return std::pair(a, b); }
};

/// Calls visit(first, last) for each run of sides with one edge.
template <class Visit>
void for_each_edge(std::vector<Side>& sides, Visit const& visit)
{
  std::ranges::sort(sides, {}, [](Side const& s) { return std::tuple(s.a, s.b, s.facet); });
  for (auto i = sides.begin(), j = i; i != sides.end(); i = j) {
    while (j != sides.end() && j->edge() == i->edge()) ++j;
    visit(i, j);
  }
}

/// The sides that their component uses an odd number of times, one each. Sides come out sorted.
std::vector<Side> odd_sides(std::vector<Side>& sides, Components& components)
{
  for (auto& s : sides) s.facet = components.find(s.facet);
  std::vector<Side> odd;
  for_each_edge(sides, [&](auto first, auto last) {
    for (auto i = first, j = i; i != last; i = j) {
      while (j != last && j->facet == i->facet) ++j;
      if ((j - i) % 2 == 1) odd.push_back(*i);
    }
  });
  return odd;
}

/// Cuts sides at the ends of other sides that lie on them.
std::vector<Side> cut(std::vector<Point3d> const& vertices, std::vector<Side> const& sides)
{
  if (sides.size() > most_open_sides) return sides;
  std::vector<Index> ends;
  for (auto const& s : sides) ends.push_back(s.a), ends.push_back(s.b);
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Side> out;
  for (auto const& s : sides) {
    Index from = s.a;
    for (auto const i : vertices_on_side(vertices, ends, s.a, s.b)) {
      out.push_back({from, i, s.facet});
      from = i;
    }
    out.push_back({from, s.b, s.facet});
  }
  return out;
}

}  // namespace

std::vector<Index> vertices_on_side(std::span<Point3d const> vertices, std::span<Index const> ends, Index first,
                                    Index last)
{
  Point3d const &a = vertices[first], &b = vertices[last];
  auto const [low_y, high_y] = std::minmax(a.y, b.y);
  auto const [low_z, high_z] = std::minmax(a.z, b.z);
  std::vector<Index> out;
  // Lexicographic order is the order along the side.
  for (auto i = std::ranges::upper_bound(ends, first); i != ends.end() && *i < last; ++i) {
    Point3d const& p = vertices[*i];
    if (p.y >= low_y && p.y <= high_y && p.z >= low_z && p.z <= high_z && projection_axis<Filtered>(a, b, p) < 0)
      out.push_back(*i);
  }
  return out;
}

std::vector<MeshShell> mesh_shells(Scene const& scene, std::span<Index const> triangles, std::size_t most_facets)
{
  Welded const mesh = weld(scene, triangles);
  Components components(mesh.facets.size());
  std::vector<Side> sides;
  for (Index f = 0; f < mesh.facets.size(); ++f) {
    auto const& [a, b, c] = mesh.facets[f];
    sides.insert(sides.end(), {{a, b, f}, {b, c, f}, {a, c, f}});
  }
  for_each_edge(sides, [&](auto first, auto last) {
    if (last - first == 2) components.join(first->facet, std::next(first)->facet);
  });

  // Join components at open ends above their feet; open ends at the feet are what a floor is for.
  std::vector<Side> open = odd_sides(sides, components);
  if (!open.empty()) open = cut(mesh.vertices, open);
  std::vector<double> foot(mesh.facets.size(), std::numeric_limits<double>::infinity());
  for (Index f = 0; f < mesh.facets.size(); ++f)
    for (auto const v : mesh.facets[f]) {
      double& z = foot[components.find(f)];
      z = std::min(z, mesh.vertices[v].z);
    }
  auto const height = [&](Side const& s) { return std::max(mesh.vertices[s.a].z, mesh.vertices[s.b].z); };
  std::vector<std::pair<Index, Index>> joins;
  for_each_edge(open, [&](auto first, auto last) {
    if (std::any_of(first, last, [&](Side const& s) { return height(s) > foot[s.facet]; }))
      for (auto i = std::next(first); i != last; ++i) joins.emplace_back(first->facet, i->facet);
  });
  for (auto const& [f, g] : joins) components.join(f, g);
  std::vector<double> floor(mesh.facets.size(), -std::numeric_limits<double>::infinity());
  for (auto const& s : odd_sides(open, components)) floor[s.facet] = std::max(floor[s.facet], height(s));

  std::vector<Index> order(mesh.facets.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, {}, [&](Index f) { return components.find(f); });
  std::vector<MeshShell> shells;
  std::vector<Index> local(mesh.vertices.size());
  std::vector<Index> owner(mesh.vertices.size(), static_cast<Index>(-1));
  for (std::size_t i = 0, j = 0; i < order.size(); i = j) {
    Index const root = components.find(order[i]);
    while (j < order.size() && components.find(order[j]) == root) ++j;
    if (j - i > most_facets || j - i < 3) continue;
    MeshShell shell{{}, {}, {}, floor[root]};
    for (auto k = i; k < j; ++k) {
      Triple f = mesh.facets[order[k]];
      for (auto& v : f) {
        if (owner[v] != root) {
          owner[v] = root;
          local[v] = static_cast<Index>(shell.vertices.size());
          shell.vertices.push_back(mesh.vertices[v]);
          shell.bounds.extend(mesh.vertices[v]);
        }
        v = local[v];
      }
      shell.facets.push_back(f);
    }
    if (shell.floor < shell.bounds.max.z) shells.push_back(std::move(shell));
  }
  return shells;
}

bool encloses(MeshShell const& shell, Point3d const& p)
{
  // Aside means (p.x + d, p.y + e) with 0 < e << d << 1: an end at p.y is below, a point on an edge is to its right.
  Point2d const foot = horizontal(p);
  bool odd = false;
  for (std::size_t f = 0; f < shell.facets.size(); ++f) {
    Triangle const t = shell.triangle(f);
    auto const& v = t.vertices;
    if (std::ranges::all_of(v, [&](Point3d const& q) { return q.z <= p.z; })) continue;
    bool inside = false;
    for (std::size_t i = 0; i < 3; ++i) {
      Point2d a = horizontal(v[i]), b = horizontal(v[(i + 1) % 3]);
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (a.y > b.y) std::swap(a, b);
      inside ^= is_positive(orient2d<Filtered>(a, b, foot));  // strictly left of an edge that runs upward
    }
    if (!inside) continue;
    Sign const turn = orient2d<Filtered>(horizontal(v[0]), horizontal(v[1]), horizontal(v[2]));
    odd ^= is_negative(orient3d<Filtered>(v[0], v[1], v[2], p) * turn);  // p below the plane
  }
  return odd;
}

}  // namespace visibility::detail
