#include "inner_certificate.hpp"

#include "plan.hpp"

#include "visibility/geometry/triangle_meets_interior.hpp"
#include "visibility/kernel/arithmetic.hpp"

namespace visibility::detail {

namespace {

/// Whether the closed box keeps out of the open one.
bool keeps_out(Box const& closed, Box const& open)
{
  return closed.max.x <= open.min.x || open.max.x <= closed.min.x || closed.max.y <= open.min.y ||
         open.max.y <= closed.min.y || closed.max.z <= open.min.z || open.max.z <= closed.min.z;
}

/// A point strictly inside, unless rounding fails it.
Point3d middle(ConvexPrism const& body)
{
  Point2d const p = plan::mean(body.footprint);
  return {p.x, p.y, body.bottom + (body.top - body.bottom) / 2};
}
Point3d middle(ConvexPolyhedron const& body)
{
  Point3d sum{0, 0, 0};
  for (auto const& v : body.vertices) sum = {sum.x + v.x, sum.y + v.y, sum.z + v.z};
  double const n = static_cast<double>(body.vertices.size());
  return {sum.x / n, sum.y / n, sum.z / n};
}

template <class Body>
bool certify(MeshShell const& shell, Body const& body)
{
  Box const bounds = visibility::bounding_box(body);
  if (!(bounds.min.z >= shell.floor)) return false;
  Point3d const p = middle(body);
  if (!meets_interior<Filtered>(Triangle{{p, p, p}}, body)) return false;
  for (std::size_t f = 0; f < shell.facets.size(); ++f) {
    Triangle const t = shell.triangle(f);
    if (keeps_out(visibility::bounding_box(t), bounds)) continue;
    if (meets_interior<Filtered>(t, body)) return false;
  }
  return encloses(shell, p);
}

}  // namespace

bool is_certified(MeshShell const& shell, ConvexPrism const& body) { return certify(shell, body); }
bool is_certified(MeshShell const& shell, ConvexPolyhedron const& body) { return certify(shell, body); }

}  // namespace visibility::detail
