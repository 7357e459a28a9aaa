#include "visibility/methods/exact_25d/seam.hpp"

#include "top_plane.hpp"

#include <utility>

namespace visibility::exact_25d {

std::vector<SeamPart> foot_seams(HeightField const& field, CrossedEdge const& wall, Foot const& foot)
{
  auto const& edge = field.edges()[wall.edge];
  Point3q const a = exact(edge.a), b = exact(edge.b);
  TopPlane const top(field.corners(field.columns()[foot.column]));
  auto const at = [&](RationalNumber const& t) {
    RationalNumber const x = a.x + t * (b.x - a.x), y = a.y + t * (b.y - a.y);
    return Point3q{x, y, top.at(x, y)};
  };
  std::vector<SeamPart> out;
  for (auto const& part : foot.parts) {
    SeamPart seam{at(part.low), at(part.high)};
    if (wall.from_left) std::swap(seam.left, seam.right);
    out.push_back(std::move(seam));
  }
  return out;
}

}  // namespace visibility::exact_25d
