#include "visibility/evidence/witness.hpp"

#include "visibility/evidence/sight_line.hpp"

#include <algorithm>

namespace visibility {

namespace {

bool is_free(PreparedScene const& scene, Point3d const& from, FacePoint const& to)
{
  if (!to.exact) return from != to.rounded && !blocker<Filtered>(scene, from, to.rounded);
  Point3<EnclosedRational> const p = enclosed(from), q = enclosed(*to.exact);
  return p != q && !blocker<FilteredRational>(scene, p, q);
}

}  // namespace

bool confirm(PreparedScene const& scene, ViewCell const& cell, Witness const& w)
{
  return w.object < scene.scene().objects.size() && w.from != w.to && in_interior(cell, w.from) &&
         in_face_interior(scene, w.object, w.to) && !blocker<Rational>(scene, w.from, w.to);
}

std::optional<Witness> find_witness(PreparedScene const& scene, Candidate const& c)
{
  Point3d const inner = middle(scene, c.face, c.from);
  for (double const pull : {0.0, 0x1p-14, 0x1p-7, 0x1p-2}) {
    auto const to = point_inside(scene, c.face, between(c.near, inner, pull));
    if (!to) return {};
    if (is_free(scene, c.from, *to)) return Witness{c.object, exact(c.from), to->point()};
  }
  return {};
}

}  // namespace visibility
