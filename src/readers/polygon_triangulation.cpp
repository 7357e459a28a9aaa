#include "polygon_triangulation.hpp"

#include "geometry/canonical_delaunay.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient2d.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace visibility::readers {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
enum class Side : std::uint8_t { unknown, outside, inside };
using FaceBase =
  CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<Side, Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
  Kernel,
  CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<VertexIndex, Kernel>, FaceBase>,
  CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Vertex = Cdt::Vertex_handle;
using Rings = std::span<std::vector<VertexIndex> const>;

/// The points without one coordinate, the others in cyclic order, so that orientation is kept up to the sign of the
/// normal's dropped coordinate.
struct Projection {
  std::span<Point3d const> points;
  int axis;
  Point2d operator()(VertexIndex i) const
  {
    auto const& p = points[i];
    return axis == 0 ? Point2d{p.y, p.z} : axis == 1 ? Point2d{p.z, p.x} : Point2d{p.x, p.y};
  }
};

/// Axes by decreasing size of Newell's normal [Sutherland et al. 1974], computed in doubles: any choice is valid.
std::array<int, 3> axes_by_normal(std::span<Point3d const> points, std::vector<VertexIndex> const& ring)
{
  std::array<double, 3> n{};
  auto const& o = points[ring[0]];
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    auto const &a = points[ring[i]], &b = points[ring[i + 1]];
    n[0] += (a.y - o.y) * (b.z - o.z) - (a.z - o.z) * (b.y - o.y);
    n[1] += (a.z - o.z) * (b.x - o.x) - (a.x - o.x) * (b.z - o.z);
    n[2] += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  for (double& x : n) x = std::isfinite(x) ? std::fabs(x) : 0;  // an order, whatever overflows
  std::array<int, 3> axes{2, 0, 1};
  std::ranges::stable_sort(axes, [&](int a, int b) { return n[std::size_t(a)] > n[std::size_t(b)]; });
  return axes;
}

/// Twice the signed area.
ExactNumber doubled_area(Projection const& at, std::span<VertexIndex const> loop)
{
  ExactNumber sum(0);
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    auto const a = at(loop[i]), b = at(loop[(i + 1) % n]);
    sum = sum + ExactNumber(a.x) * ExactNumber(b.y) - ExactNumber(b.x) * ExactNumber(a.y);
  }
  return sum;
}

/// A closed walk over triangulation vertices, and how often (mod 2) the rings run along each edge.
using EdgeParity = std::map<std::pair<Vertex, Vertex>, bool>;

std::pair<Vertex, Vertex> key(Vertex a, Vertex b) { return a < b ? std::pair(a, b) : std::pair(b, a); }

/// The vertices between a and b on an inserted constraint: it was split where a vertex lies on it.
bool toggle_along(Cdt const& cdt, Vertex a, Vertex b, EdgeParity& parity)
{
  auto const ordered = Kernel::Collinear_are_strictly_ordered_along_line_2{};
  for (Vertex v = a; v != b;) {
    Vertex next{};
    auto e = cdt.incident_edges(v);
    auto const end = e;
    do {
      if (cdt.is_infinite(e)) continue;
      Vertex const w = e->first->vertex(Cdt::cw(e->second)) == v ? e->first->vertex(Cdt::ccw(e->second))
                                                                 : e->first->vertex(Cdt::cw(e->second));
      if (w == b) {
        next = w;
        break;
      }
      if (CGAL::collinear(v->point(), w->point(), b->point()) && ordered(v->point(), w->point(), b->point())) next = w;
    } while (++e != end);
    if (next == Vertex{}) return false;
    bool& odd = parity[key(v, next)];
    odd = !odd;
    v = next;
  }
  return true;
}

/// Says for each face whether it is inside by the even-odd rule.
void mark_sides(Cdt& cdt, EdgeParity const& parity)
{
  for (auto const f : cdt.all_face_handles()) f->info() = Side::unknown;  // CGAL leaves it uninitialised
  std::vector<Cdt::Face_handle> stack{cdt.infinite_face()};
  cdt.infinite_face()->info() = Side::outside;
  while (!stack.empty()) {
    auto const f = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      auto const g = f->neighbor(i);
      if (g->info() != Side::unknown) continue;
      auto const it = parity.find(key(f->vertex(Cdt::cw(i)), f->vertex(Cdt::ccw(i))));
      bool const crosses = it != parity.end() && it->second;
      g->info() = crosses == (f->info() == Side::outside) ? Side::inside : Side::outside;
      stack.push_back(g);
    }
  }
}

/// Inserts all rings; false if two edges cross or two points of different height fall together.
bool insert(Cdt& cdt, Projection const& at, Rings rings, EdgeParity& parity)
{
  std::vector<std::vector<Vertex>> loops;
  Cdt::Face_handle hint{};
  for (auto const& ring : rings) {
    auto& loop = loops.emplace_back();
    for (auto const i : ring) {
      auto const p = at(i);
      auto const before = cdt.number_of_vertices();
      auto const v = cdt.insert(Kernel::Point_2(p.x, p.y), hint);
      if (cdt.number_of_vertices() > before)
        v->info() = i;
      else if (at.points[v->info()] != at.points[i])
        return false;
      hint = v->face();
      loop.push_back(v);
    }
  }
  if (cdt.dimension() < 2) return false;
  try {
    for (auto const& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (auto const a = loop[i], b = loop[(i + 1) % loop.size()]; a != b) cdt.insert_constraint(a, b);
  } catch (Cdt::Intersection_of_constraints_exception const&) {
    return false;
  }
  for (auto const& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (!toggle_along(cdt, loop[i], loop[(i + 1) % loop.size()], parity)) return false;
  visibility::detail::canonicalize(cdt);
  mark_sides(cdt, parity);
  return true;
}

/// Whether the triangles have the area of the outer ring less that of the holes. Holes outside the outer ring, holes
/// that overlap and rings that wind twice fail it, although no two edges cross.
bool area_agrees(Projection const& at, Rings rings, std::span<IndexTriangle const> triangles)
{
  ExactNumber sum(0);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    ExactNumber const area = doubled_area(at, rings[i]);
    bool const add = (CGAL::sign(area) == CGAL::POSITIVE) == (i == 0);
    sum = add ? sum + area : sum - area;
  }
  for (auto const& t : triangles) sum = sum - doubled_area(at, t);
  return CGAL::is_zero(sum);
}

bool triangulate_along(Projection const& at, Rings rings, std::vector<IndexTriangle>& out)
{
  Cdt cdt;
  EdgeParity parity;
  if (!insert(cdt, at, rings, parity)) return false;
  std::vector<IndexTriangle> triangles;
  for (auto const f : cdt.finite_face_handles())
    if (f->info() == Side::inside)
      triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  for (auto& t : triangles) std::ranges::rotate(t, std::ranges::min_element(t));
  std::ranges::sort(triangles);
  if (triangles.empty() || !area_agrees(at, rings, triangles)) return false;
  if (CGAL::sign(doubled_area(at, rings[0])) == CGAL::NEGATIVE)
    for (auto& t : triangles) std::swap(t[1], t[2]);
  out.insert(out.end(), triangles.begin(), triangles.end());
  return true;
}

/// A quadrangle whose four turns have one sign is simple and convex: two triangles will do.
bool is_convex_quadrangle(Projection const& at, std::vector<VertexIndex> const& q)
{
  int turns = 0;
  for (std::size_t i = 0; i < 4; ++i)
    turns += static_cast<int>(orient2d<Filtered>(at(q[i]), at(q[(i + 1) % 4]), at(q[(i + 2) % 4])));
  return std::abs(turns) == 4;
}

bool is_flat_line(std::span<Point3d const> points, std::vector<VertexIndex> const& ring)
{
  for (int axis = 0; axis < 3; ++axis) {
    Projection const at{points, axis};
    auto const first = at(ring[0]);
    auto const second = std::ranges::find_if(ring, [&](VertexIndex i) { return at(i) != first; });
    if (second == ring.end()) continue;
    for (auto const i : ring)
      if (!is_zero(orient2d<Filtered>(first, at(*second), at(i)))) return false;
  }
  return true;
}

}  // namespace

Triangulated triangulate(std::span<Point3d const> vertices, Rings rings, std::vector<IndexTriangle>& out)
{
  auto const& outer = rings[0];
  if (outer.size() < 3) return Triangulated::no_area;
  if (rings.size() == 1 && outer.size() == 3) {
    out.push_back({outer[0], outer[1], outer[2]});
    return Triangulated::yes;
  }
  auto const axes = axes_by_normal(vertices, outer);
  if (rings.size() == 1 && outer.size() == 4 && is_convex_quadrangle({vertices, axes[0]}, outer)) {
    out.push_back({outer[0], outer[1], outer[2]});
    out.push_back({outer[0], outer[2], outer[3]});
    return Triangulated::yes;
  }
  if (is_flat_line(vertices, outer)) return Triangulated::no_area;
  for (int const axis : axes)
    if (triangulate_along({vertices, axis}, rings, out)) return Triangulated::yes;
  return Triangulated::not_simple;
}

void drop_repeats(std::span<Point3d const> vertices, std::vector<VertexIndex>& ring)
{
  auto const same = [&](VertexIndex a, VertexIndex b) { return vertices[a] == vertices[b]; };
  ring.erase(std::unique(ring.begin(), ring.end(), same), ring.end());
  while (ring.size() > 1 && same(ring.front(), ring.back())) ring.pop_back();
}

void DroppedPolygons::count(Triangulated result)
{
  no_area += result == Triangulated::no_area;
  not_simple += result == Triangulated::not_simple;
}

void DroppedPolygons::note(SceneBuilder& builder) const
{
  if (no_area > 0) builder.note(std::to_string(no_area) + " polygons without area left out");
  if (not_simple > 0) builder.note(std::to_string(not_simple) + " polygons whose rings cross or overlap left out");
}

}  // namespace visibility::readers
