#pragma once

#include "visibility/geometry/box.hpp"
#include "visibility/geometry/convex_polyhedron.hpp"
#include "visibility/geometry/convex_prism.hpp"
#include "visibility/geometry/triangle.hpp"

#include <vector>

namespace visibility {

/// Appends the vertices of a shape, whose hull it is: 8, twice the corners of the footprint, those stored, or 3; not
/// always different ones.
inline void append_vertices(Box const& b, std::vector<Point3d>& out)
{
  auto const corners = b.corners();
  out.insert(out.end(), corners.begin(), corners.end());
}
inline void append_vertices(ConvexPrism const& p, std::vector<Point3d>& out)
{
  for (auto const& v : p.footprint) {
    out.push_back({v.x, v.y, p.bottom});
    out.push_back({v.x, v.y, p.top});
  }
}
inline void append_vertices(ConvexPolyhedron const& p, std::vector<Point3d>& out)
{
  out.insert(out.end(), p.vertices.begin(), p.vertices.end());
}
inline void append_vertices(Triangle const& t, std::vector<Point3d>& out)
{
  out.insert(out.end(), t.vertices.begin(), t.vertices.end());
}

}  // namespace visibility
