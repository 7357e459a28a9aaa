#include "visibility/scene/enclosing_shells.hpp"

#include "mesh_shells.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace visibility {

namespace {

using Index = std::uint32_t;
using Side = std::pair<Index, Index>;  // the smaller index first

Side side(Index a, Index b) { return std::minmax(a, b); }

/// Calls visit(side, count) for each side once. Sorts them.
template <class Visit>
void count_sides(std::vector<Side>& sides, Visit const& visit)
{
  std::ranges::sort(sides);
  for (auto i = sides.begin(), j = i; i != sides.end(); i = j) {
    while (j != sides.end() && *j == *i) ++j;
    visit(*i, j - i);
  }
}

/// Puts vertices in lexicographic order.
void sort_vertices(detail::MeshShell& shell)
{
  std::vector<Index> order(shell.vertices.size()), place(order.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, [&](Index v) {
    Point3d const& p = shell.vertices[v];
    return std::tuple(p.x, p.y, p.z);
  });
  std::vector<Point3d> sorted;
  for (Index k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    sorted.push_back(shell.vertices[order[k]]);
  }
  shell.vertices = std::move(sorted);
  for (auto& f : shell.facets)
    for (auto& v : f) v = place[v];
}

/// A side and the vertices on it, in order.
struct CutSide {
  Side ends;
  std::vector<Index> between;
};

/// The sides that are used an odd number of times, cut at each other's ends; ascending.
std::vector<CutSide> cut_sides(detail::MeshShell const& shell)
{
  std::vector<Side> sides;
  for (auto const& f : shell.facets)
    for (std::size_t k = 0; k < 3; ++k) sides.push_back(side(f[k], f[(k + 1) % 3]));
  std::vector<CutSide> odd;
  std::vector<Index> ends;
  count_sides(sides, [&](Side const& s, auto count) {
    if (count % 2 == 0) return;
    odd.push_back({s, {}});
    ends.insert(ends.end(), {s.first, s.second});
  });
  if (odd.size() > detail::most_open_sides) return {};
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (auto& s : odd) s.between = detail::vertices_on_side(shell.vertices, ends, s.ends.first, s.ends.second);
  return odd;
}

EnclosingShell with_cut_sides(detail::MeshShell shell, Index object)
{
  sort_vertices(shell);
  auto const cuts = cut_sides(shell);
  EnclosingShell out{std::move(shell.vertices), {}, {0}, shell.bounds, 0, object};
  std::vector<Side> sides;
  for (auto const& f : shell.facets) {
    for (std::size_t k = 0; k < 3; ++k) {
      Side const s = side(f[k], f[(k + 1) % 3]);
      out.around.push_back(f[k]);
      auto const cut = std::ranges::lower_bound(cuts, s, {}, &CutSide::ends);
      if (cut == cuts.end() || cut->ends != s) continue;
      if (f[k] == s.first)
        out.around.insert(out.around.end(), cut->between.begin(), cut->between.end());
      else
        out.around.insert(out.around.end(), cut->between.rbegin(), cut->between.rend());
    }
    out.first_of_facet.push_back(static_cast<Index>(out.around.size()));
    auto const around = out.facet(out.facets() - 1);
    for (std::size_t k = 0; k < around.size(); ++k)
      sides.push_back(side(around[k], around[k + 1 == around.size() ? 0 : k + 1]));
  }
  // What is even is decided here, whatever led to it.
  out.floor = -std::numeric_limits<double>::infinity();
  count_sides(sides, [&](Side const& s, auto count) {
    if (count % 2 == 1) out.floor = std::max({out.floor, out.vertices[s.first].z, out.vertices[s.second].z});
  });
  return out;
}

}  // namespace

EnclosingShells::EnclosingShells(ConvexBodies const& bodies, std::size_t most_facets)
{
  Scene const& scene = bodies.scene();
  std::vector<Index> triangles;
  for (Index o = 0; o < scene.objects.size(); ++o) {
    first_of_object_.push_back(static_cast<Index>(shells_.size()));
    Object const& object = scene.objects[o];
    auto const is_loose = [](ConvexBodies::Body const& b) { return b.kind == ConvexBodies::Kind::triangle; };
    if (!object.occludes || std::ranges::none_of(bodies.bodies_of(o), is_loose)) continue;
    triangles.resize(object.triangles.size());
    std::iota(triangles.begin(), triangles.end(), object.triangles.first);
    for (auto& shell : detail::mesh_shells(scene, triangles, most_facets)) {
      auto enclosing = with_cut_sides(std::move(shell), o);
      if (enclosing.floor < enclosing.bounds.max.z) shells_.push_back(std::move(enclosing));
    }
  }
  first_of_object_.push_back(static_cast<Index>(shells_.size()));
}

}  // namespace visibility
