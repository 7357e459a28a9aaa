#include "visibility/scene/footprint.hpp"

#include "geometry/canonical_delaunay.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient2d.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <algorithm>
#include <list>
#include <map>

namespace visibility {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct FaceInfo {
  int depth = -1;  ///< number of constraints crossed from the outside; odd: inside
  int piece = -1;
};
using FaceBase =
  CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
  Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, FaceBase>,
  CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// Inserts a ring; false if it crosses what is there.
bool insert(Cdt& cdt, std::vector<Point2d> const& ring)
{
  std::vector<Cdt::Vertex_handle> v;
  for (auto const& p : ring) {
    auto const h = cdt.insert(Kernel::Point_2(p.x, p.y));
    if (v.empty() || v.back() != h) v.push_back(h);
  }
  if (v.size() > 1 && v.front() == v.back()) v.pop_back();
  if (v.size() < 3) return false;
  try {
    for (std::size_t i = 0; i < v.size(); ++i) cdt.insert_constraint(v[i], v[(i + 1) % v.size()]);
  } catch (Cdt::Intersection_of_constraints_exception const&) {
    return false;
  }
  return true;
}

/// Numbers the faces by the constraints that separate them from the outside.
void mark_depths(Cdt& cdt)
{
  std::list<Cdt::Face_handle> frontier{cdt.infinite_face()};
  cdt.infinite_face()->info().depth = 0;
  while (!frontier.empty()) {
    std::list<Cdt::Face_handle> component{frontier.front()};
    frontier.pop_front();
    while (!component.empty()) {
      auto const f = component.front();
      component.pop_front();
      for (int i = 0; i < 3; ++i) {
        auto const g = f->neighbor(i);
        if (g->info().depth >= 0) continue;
        bool const crosses = cdt.is_constrained({f, i});
        g->info().depth = f->info().depth + (crosses ? 1 : 0);
        (crosses ? frontier : component).push_back(g);
      }
    }
  }
}

using Loop = std::vector<Point2d>;

/// Twice the signed area.
ExactNumber doubled_area(Loop const& loop)
{
  ExactNumber sum(0);
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    auto const &a = loop[i], &b = loop[(i + 1) % n];
    sum = sum + ExactNumber(a.x) * ExactNumber(b.y) - ExactNumber(b.x) * ExactNumber(a.y);
  }
  return sum;
}

/// Whether the pieces have the area of the outer ring less that of the holes. Rings that share an edge, lie outside
/// the outer ring, overlap or wind twice fail it, although no two of their edges cross.
bool area_agrees(std::vector<Loop> const& rings, std::vector<Loop> const& pieces)
{
  ExactNumber sum(0);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    ExactNumber const area = doubled_area(rings[i]);
    bool const add = (CGAL::sign(area) == CGAL::POSITIVE) == (i == 0);
    sum = add ? sum + area : sum - area;
  }
  for (auto const& p : pieces) sum = sum - doubled_area(p);
  return CGAL::is_zero(sum);
}

/// The union of two convex loops that share the edge a -> b of `left` (b -> a of `right`), if it is convex; `strictly`:
/// and has a corner at a and b.
bool join(Loop const& left, Loop const& right, Point2d const& a, Point2d const& b, bool strictly, Loop& out)
{
  auto const start_at = [](Loop const& loop, Point2d const& p) {
    return static_cast<std::size_t>(std::ranges::find(loop, p) - loop.begin());
  };
  // Pieces that share more than one edge (collinear ones) would leave a spike.
  auto const shared = std::ranges::count_if(left, [&](Point2d const& p) { return start_at(right, p) < right.size(); });
  if (shared != 2) return false;
  out.clear();
  std::size_t const l = start_at(left, b), r = start_at(right, a);
  for (std::size_t i = 0; i + 1 < left.size(); ++i) out.push_back(left[(l + i) % left.size()]);
  for (std::size_t i = 0; i + 1 < right.size(); ++i) out.push_back(right[(r + i) % right.size()]);
  // Only the turns at a and b are new; a is out[left.size() - 1], b is out[0].
  auto const fits = [&](std::size_t i) {
    std::size_t const n = out.size();
    Sign const turn = orient2d<Filtered>(out[(i + n - 1) % n], out[i], out[(i + 1) % n]);
    return is_positive(turn) || (!strictly && is_zero(turn));
  };
  return fits(0) && fits(left.size() - 1);
}

}  // namespace

Box bounding_box(Prism const& prism)
{
  Box b;
  for (auto const& ring : prism.rings)
    for (auto const& v : ring) b.extend(Point3d{v.x, v.y, prism.bottom});
  b.max.z = prism.top;
  return b;
}

std::vector<ConvexPrism> convex_partition(Prism const& prism)
{
  if (!(prism.bottom < prism.top)) return {};
  Cdt cdt;
  for (auto const& ring : prism.rings)
    if (!insert(cdt, ring)) return {};
  if (cdt.dimension() < 2) return {};
  detail::canonicalize(cdt);
  mark_depths(cdt);

  std::vector<Loop> pieces;
  std::vector<Cdt::Edge> diagonals;
  for (auto const f : cdt.finite_face_handles()) {
    if (f->info().depth % 2 == 0) continue;
    if (f->info().depth != 1) return {};  // an island in a hole is not a polygon with holes
    f->info().piece = static_cast<int>(pieces.size());
    Loop loop;
    for (int i = 0; i < 3; ++i) loop.push_back({f->vertex(i)->point().x(), f->vertex(i)->point().y()});
    pieces.push_back(std::move(loop));
  }
  if (!area_agrees(prism.rings, pieces)) return {};
  for (auto const& e : cdt.finite_edges()) {
    auto const g = e.first->neighbor(e.second);
    if (!cdt.is_constrained(e) && e.first->info().piece >= 0 && g->info().piece >= 0) diagonals.push_back(e);
  }

  // In an order that the input determines.
  std::ranges::sort(diagonals, {}, [](Cdt::Edge const& e) {
    auto const &a = e.first->vertex(Cdt::ccw(e.second))->point(), &b = e.first->vertex(Cdt::cw(e.second))->point();
    return std::minmax({std::pair(a.x(), a.y()), std::pair(b.x(), b.y())});
  });

  // Hertel and Mehlhorn: remove a diagonal wherever the union of its two pieces stays convex.
  std::vector<int> parent(pieces.size());
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = static_cast<int>(i);
  auto const find = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return static_cast<std::size_t>(i);
  };
  // Straight angles come last: at a reflex corner they leave the other pieces nothing to join with.
  Loop joined;
  for (bool const strictly : {true, false})
    for (auto const& [f, i] : diagonals) {
      auto const left = find(f->info().piece), right = find(f->neighbor(i)->info().piece);
      if (left == right) continue;
      auto const point = [&f = f](int k) { return Point2d{f->vertex(k)->point().x(), f->vertex(k)->point().y()}; };
      if (!join(pieces[left], pieces[right], point(Cdt::ccw(i)), point(Cdt::cw(i)), strictly, joined)) continue;
      pieces[left] = joined;
      pieces[right].clear();
      parent[right] = static_cast<int>(left);
    }
  std::erase_if(pieces, [](Loop const& loop) { return loop.empty(); });
  auto const less = [](Point2d const& a, Point2d const& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
  for (auto& loop : pieces) std::ranges::rotate(loop, std::ranges::min_element(loop, less));
  std::ranges::sort(pieces, [&](Loop const& a, Loop const& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
  });
  std::vector<ConvexPrism> out;
  for (auto& loop : pieces) out.push_back({std::move(loop), prism.bottom, prism.top});
  return out;
}

}  // namespace visibility
