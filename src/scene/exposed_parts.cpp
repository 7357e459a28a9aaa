#include "visibility/scene/exposed_parts.hpp"

#include "edge_cover.hpp"

namespace visibility {

namespace {

using namespace height_field;

constexpr double infinity = std::numeric_limits<double>::infinity();

Sign side_of(Crossing crossing) { return crossing == Crossing::entering ? Sign::negative : Sign::positive; }

}  // namespace

template <Arithmetic A>
ExposedParts exposed_parts(HeightField const& field, std::uint32_t edge, Crossing crossing)
{
  auto const& e = field.edges()[edge];
  bool const sees_top = crossing == Crossing::leaving && !field.columns()[e.column].is_curtain();
  EdgeCover<A, Point3d> const cover(field, e.a, e.b, side_of(crossing), e.column, sees_top);
  Box reach = bounding_box(e);  // a column that is lower than the edge covers nothing
  reach.max.z = infinity;
  return uncovered(field, cover, reach, [] { return OpenInterval{0, 1}; });
}

template ExposedParts exposed_parts<Filtered>(HeightField const&, std::uint32_t, Crossing);
template ExposedParts exposed_parts<Rational>(HeightField const&, std::uint32_t, Crossing);

}  // namespace visibility
