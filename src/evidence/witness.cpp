#include "visibility/evidence/witness.hpp"

#include "visibility/evidence/sight_line.hpp"

#include <algorithm>

namespace visibility {

namespace {

template <Arithmetic A, class NT>
bool strictly_inside(ConvexPolyhedron const& shape, Point3<NT> const& p)
{
  return std::ranges::all_of(shape.facets, [&](ConvexPolyhedron::Facet const& f) {
    auto const v = [&](std::size_t i) { return detail::as<NT>(shape.vertices[f.vertices[i]]); };
    return is_negative(orient3d<A>(v(0), v(1), v(2), p));
  });
}

Point3d towards(Point3d const& a, Point3d const& b, double t)
{
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

bool is_free(PreparedScene const& scene, Point3d const& from, FacePoint const& to)
{
  if (!to.exact) return from != to.rounded && !blocker<Filtered>(scene, from, to.rounded);
  Point3<Coordinate> const p = coordinates(from), q = coordinates(*to.exact);
  return p != q && !blocker<FilteredRational>(scene, p, q);
}

}  // namespace

bool in_interior(ViewCell const& cell, Point3d const& p)
{
  Box const& b = cell.bounds();
  bool const inside =
    b.min.x < p.x && p.x < b.max.x && b.min.y < p.y && p.y < b.max.y && b.min.z < p.z && p.z < b.max.z;
  return inside && (cell.is_box() || strictly_inside<Filtered>(cell.shape(), p));
}

bool in_interior(ViewCell const& cell, Point3q const& p) { return strictly_inside<Rational>(cell.shape(), p); }

bool confirm(PreparedScene const& scene, ViewCell const& cell, Witness const& w)
{
  return w.object < scene.scene().objects.size() && w.from != w.to && in_interior(cell, w.from) &&
         in_face_interior(scene, w.object, w.to) && !blocker<Rational>(scene, w.from, w.to);
}

std::optional<Witness> find_witness(PreparedScene const& scene, Candidate const& c)
{
  Point3d const inner = middle(scene, c.face, c.from);
  for (double const pull : {0.0, 0x1p-14, 0x1p-7, 0x1p-2}) {
    auto const to = point_inside(scene, c.face, towards(c.near, inner, pull));
    if (!to) return {};
    if (is_free(scene, c.from, *to)) return Witness{c.object, exact(c.from), to->point()};
  }
  return {};
}

}  // namespace visibility
