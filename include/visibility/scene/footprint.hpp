#pragma once

#include "visibility/geometry/convex_prism.hpp"

#include <vector>

namespace visibility {

/// Vertical prism over a polygon with holes: the walls are the ring edges, floor and roof the polygon at bottom and
/// top. Rings are open (the first point is not repeated), of any orientation; rings[0] is the outer one.
struct Prism {
  std::vector<std::vector<Point2d>> rings;
  double bottom = 0, top = 0;
};

Box bounding_box(Prism const& prism);

/// Convex pieces whose union is the prism, without new points: constrained Delaunay triangles of the footprint (CGAL,
/// exact predicates) joined while the union stays convex [Hertel & Mehlhorn 1983]. Pieces do not overlap.
/// Empty if the footprint is not a polygon with holes (crossing rings, no area) or bottom >= top: such a prism cannot
/// be trusted to be solid.
std::vector<ConvexPrism> convex_partition(Prism const& prism);

}  // namespace visibility
