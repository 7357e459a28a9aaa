#include "visibility/scene/exposed_parts.hpp"

#include "edge_cover.hpp"

namespace visibility {

namespace {

using namespace height_field;

Sign side_of(Crossing crossing) { return crossing == Crossing::entering ? Sign::negative : Sign::positive; }

}  // namespace

template <Arithmetic A>
ExposedParts exposed_parts(HeightField const& field, std::uint32_t edge, Crossing crossing)
{
  auto const& e = field.edges()[edge];
  auto const& column = field.columns()[e.column];
  bool const sees_top = crossing == Crossing::leaving && !column.is_curtain();
  EdgeCover<A, Point3d> const cover(field, e.a, e.b, side_of(crossing),
                                    {sees_top ? field.corners(column) : Corners{}, e.column});
  return uncovered(field, cover, reach(e.a, e.b), [] { return OpenInterval{0, 1}; });
}

template ExposedParts exposed_parts<Filtered>(HeightField const&, std::uint32_t, Crossing);
template ExposedParts exposed_parts<Rational>(HeightField const&, std::uint32_t, Crossing);

}  // namespace visibility
