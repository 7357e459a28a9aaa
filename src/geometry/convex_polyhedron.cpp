#include "visibility/geometry/convex_polyhedron.hpp"

#include "visibility/geometry/segment_coplanar.hpp"
#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace visibility {

namespace {

using Index = ConvexPolyhedron::Index;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Names the first broken invariant, or nothing.
std::string broken_invariant(ConvexPolyhedron const& p)
{
  if (p.facets.size() < 4) return "fewer than four facets";
  if (p.vertices.size() + p.facets.size() != p.edges.size() + 2) return "not a closed surface of genus 0";
  std::vector<std::array<int, 2>> uses(p.edges.size());  // forward, reversed
  for (auto const& f : p.facets) {
    for (auto const e : f.edges) ++uses[static_cast<std::size_t>(e >= 0 ? e : ~e)][e >= 0 ? 0 : 1];
    auto const& [a, b, c] = f.vertices;
    bool has_inner = false;
    for (auto const& v : p.vertices) {
      Sign const s = orient3d<Filtered>(p.vertices[a], p.vertices[b], p.vertices[c], v);
      if (is_positive(s)) return "not convex";
      has_inner |= is_negative(s);
    }
    if (!has_inner) return "a facet without area, or all vertices in one plane";
  }
  // Once in each direction: then the facets are a cycle, and as all of them face outward they cover the whole hull.
  if (!std::ranges::all_of(uses, [](auto const& n) { return n[0] == 1 && n[1] == 1; }))
    return "an edge that does not bound two facets, once in each direction";
  return {};
}

bool lie_in_one_plane(std::span<Point3d const> points)
{
  if (points.empty()) return true;
  auto const& a = points.front();
  auto const b = std::ranges::find_if(points, [&](Point3d const& p) { return p != a; });
  if (b == points.end()) return true;
  auto const c =
    std::ranges::find_if(points, [&](Point3d const& p) { return detail::projection_axis<Filtered>(a, *b, p) >= 0; });
  if (c == points.end()) return true;
  return std::ranges::all_of(points, [&](Point3d const& p) { return is_zero(orient3d<Filtered>(a, *b, *c, p)); });
}

}  // namespace

ConvexPolyhedron ConvexPolyhedron::from_facets(std::vector<Point3d> vertices,
                                               std::span<std::array<Index, 3> const> facets)
{
  if (!std::ranges::all_of(vertices, [](Point3d const& v) { return is_finite(v); }))
    throw std::invalid_argument("a coordinate is not finite");
  ConvexPolyhedron p;
  p.vertices = std::move(vertices);
  std::map<std::pair<Index, Index>, std::int32_t> edge_of;
  for (auto const& v : facets) {
    Facet f{v, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      Index const a = v[i], b = v[(i + 1) % 3];
      if (a == b || a >= p.vertices.size()) throw std::invalid_argument("a facet has an invalid vertex");
      auto const [it, fresh] = edge_of.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(p.edges.size()));
      if (fresh) p.edges.push_back({std::min(a, b), std::max(a, b)});
      f.edges[i] = a < b ? it->second : ~it->second;
    }
    p.facets.push_back(f);
  }
  if (auto const broken = broken_invariant(p); !broken.empty()) throw std::invalid_argument(broken);
  return p;
}

ConvexPolyhedron ConvexPolyhedron::hull(std::span<Point3d const> points)
{
  std::vector<Kernel::Point_3> input;
  for (auto const& p : points) {
    if (!is_finite(p)) throw std::invalid_argument("a coordinate is not finite");
    input.emplace_back(p.x, p.y, p.z);
  }
  if (lie_in_one_plane(points)) throw std::invalid_argument("the points lie in one plane");
  CGAL::Polyhedron_3<Kernel> hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);
  std::vector<Point3d> vertices;
  std::map<Kernel::Point_3 const*, Index> index;
  for (auto v = hull.vertices_begin(); v != hull.vertices_end(); ++v) {
    index[&v->point()] = static_cast<Index>(vertices.size());
    vertices.push_back({v->point().x(), v->point().y(), v->point().z()});
  }
  std::vector<std::array<Index, 3>> facets;
  for (auto f = hull.facets_begin(); f != hull.facets_end(); ++f) {
    auto const h = f->halfedge();
    facets.push_back({index[&h->vertex()->point()], index[&h->next()->vertex()->point()],
                      index[&h->next()->next()->vertex()->point()]});
  }
  return from_facets(std::move(vertices), facets);
}

ConvexPolyhedron ConvexPolyhedron::from_box(Box const& box)
{
  auto const c = box.corners();
  static constexpr std::array<std::array<Index, 3>, 12> facets{{{0, 2, 3},
                                                                {0, 3, 1},
                                                                {4, 5, 7},
                                                                {4, 7, 6},
                                                                {0, 1, 5},
                                                                {0, 5, 4},
                                                                {2, 6, 7},
                                                                {2, 7, 3},
                                                                {0, 4, 6},
                                                                {0, 6, 2},
                                                                {1, 3, 7},
                                                                {1, 7, 5}}};
  return from_facets({c.begin(), c.end()}, facets);
}

void ConvexPolyhedron::validate() const
{
  if (auto const broken = broken_invariant(*this); !broken.empty())
    throw std::logic_error("ConvexPolyhedron: " + broken);
}

}  // namespace visibility
