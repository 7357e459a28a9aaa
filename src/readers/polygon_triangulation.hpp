#pragma once

#include "visibility/kernel/point.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace visibility {
class SceneBuilder;
}

namespace visibility::readers {

using VertexIndex = std::uint32_t;
using IndexTriangle = std::array<VertexIndex, 3>;

enum class Triangulated {
  yes,
  no_area,     ///< all points on a line, or fewer than three distinct ones
  not_simple,  ///< rings cross or overlap, or the polygon folds over itself seen along every axis
};

/// Triangulates a polygon with holes in space, without new points. rings[0] is the outer ring; rings are open and of
/// any orientation. The triangles cover, seen along the axis nearest to the polygon's normal, exactly the outer ring
/// less the holes (exact predicates, area compared exactly): never a hole, never the outside. A polygon that
/// is not flat (rounded coordinates are not quite) is taken as the surface that these triangles make.
/// Triangles are appended to `out`, turning as the outer ring does. A ring of three points is taken as it is.
Triangulated triangulate(std::span<Point3d const> vertices, std::span<std::vector<VertexIndex> const> rings,
                         std::vector<IndexTriangle>& out);

/// Removes points that repeat the one before them, also around the end; exact comparison of positions.
void drop_repeats(std::span<Point3d const> vertices, std::vector<VertexIndex>& ring);

/// Counts what could not be triangulated, for the user to know.
struct DroppedPolygons {
  std::size_t no_area = 0, not_simple = 0;
  void count(Triangulated result);
  void note(SceneBuilder& builder) const;
};

}  // namespace visibility::readers
