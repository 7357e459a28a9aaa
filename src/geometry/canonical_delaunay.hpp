#pragma once

#include <algorithm>
#include <array>

namespace visibility::detail {

/// Turns a constrained Delaunay triangulation (CGAL) into the one that its input determines. Where four or more points
/// lie on a circle the diagonals are a choice, and CGAL's depends on the addresses of its faces, so on the run. Here
/// each such diagonal ends at the lexicographically least of its four points: every flip puts an edge with a lesser
/// least end in place of another, so this ends, and in a fan, whatever it started from. Exact predicates make it exact.
/// Faces keep their places, but not their order; what is derived from them must be sorted.
template <class Cdt>
void canonicalize(Cdt& cdt)
{
  using Face = typename Cdt::Face_handle;
  auto const circle = cdt.geom_traits().side_of_oriented_circle_2_object();
  auto const should_flip = [&](Face f, int i) {
    Face const g = f->neighbor(i);
    if (cdt.is_constrained({f, i}) || cdt.is_infinite(f) || cdt.is_infinite(g)) return false;
    auto const &own = f->vertex(i)->point(), &other = cdt.tds().mirror_vertex(f, i)->point();
    auto const &a = f->vertex(Cdt::ccw(i))->point(), &b = f->vertex(Cdt::cw(i))->point();
    if (std::min(own, other) > std::min(a, b)) return false;
    return circle(own, a, b, other) == CGAL::ON_ORIENTED_BOUNDARY;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (auto it = cdt.finite_faces_begin(); it != cdt.finite_faces_end(); ++it)
      for (int i = 0; i < 3; ++i) {
        Face f = it;
        if (!should_flip(f, i)) continue;
        cdt.flip(f, i);
        changed = true;
        i = -1;  // the face is another one now
      }
  }
}

}  // namespace visibility::detail
