#pragma once

#include "visibility/geometry/ball.hpp"
#include "visibility/geometry/box.hpp"
#include "visibility/geometry/convex_polyhedron.hpp"
#include "visibility/geometry/convex_prism.hpp"
#include "visibility/geometry/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace visibility::extended_projection {

/// Appends the vertices of a shape that is their hull.
inline void append_points(Box const& b, std::vector<Point3d>& out)
{
  for (auto const& p : b.corners()) out.push_back(p);
}
inline void append_points(ConvexPrism const& p, std::vector<Point3d>& out)
{
  for (auto const& v : p.footprint) {
    out.push_back({v.x, v.y, p.bottom});
    out.push_back({v.x, v.y, p.top});
  }
}
inline void append_points(ConvexPolyhedron const& p, std::vector<Point3d>& out)
{
  out.insert(out.end(), p.vertices.begin(), p.vertices.end());
}
inline void append_points(Triangle const& t, std::vector<Point3d>& out)
{
  out.insert(out.end(), t.vertices.begin(), t.vertices.end());
}

/// Points inside the ball: of its cube and its octahedron, a little smaller, so that rounding leaves them inside.
inline void append_points(Ball const& b, std::vector<Point3d>& out)
{
  double const size = std::max({std::fabs(b.centre.x), std::fabs(b.centre.y), std::fabs(b.centre.z)}), r = b.radius;
  if (!(size * 0x1p-50 <= r * 1e-4) || r < 0x1p-500) return;
  double const h = 0.577 * r, a = 0.999 * r;
  append_points(Box{{b.centre.x - h, b.centre.y - h, b.centre.z - h}, {b.centre.x + h, b.centre.y + h, b.centre.z + h}},
                out);
  for (auto const axis : {&Point3d::x, &Point3d::y, &Point3d::z})
    for (double const way : {-a, a}) {
      Point3d p = b.centre;
      p.*axis += way;
      out.push_back(p);
    }
}

}  // namespace visibility::extended_projection
