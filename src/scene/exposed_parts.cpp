#include "visibility/scene/exposed_parts.hpp"

#include "edge_cover.hpp"

namespace visibility {

namespace {

using namespace height_field;

constexpr double infinity = std::numeric_limits<double>::infinity();

Sign side_of(Crossing crossing) { return crossing == Crossing::entering ? Sign::negative : Sign::positive; }

Box bounds_of(HeightField::TopEdge const& e)
{
  Box box;
  box.extend(e.a);
  box.extend(e.b);
  return box;
}

/// The point of the column's top plane over p.
Point3q top_over(HeightField const& field, HeightField::Column const& column, Point3d const& p)
{
  auto const c = field.corners(column);
  auto const [x0, y0, z0] = exact(c[0]);
  auto const [x1, y1, z1] = exact(c[1]);
  auto const [x2, y2, z2] = exact(c[2]);
  auto const [x, y, z] = exact(p);
  auto const area = detail::Orient2dFormula{}(x0, y0, x1, y1, x2, y2);
  return {x, y, z - detail::Orient3dFormula{}(x0, y0, z0, x1, y1, z1, x2, y2, z2, x, y, z) / area};
}

/// Where no other column covers the top of this one beside the edge.
template <Arithmetic A>
ExposedParts top_beside(HeightField const& field, HeightField::TopEdge const& e, Sign side, std::uint32_t column,
                        OpenInterval const& range)
{
  auto const& g = field.columns()[column];
  Box reach = bounds_of(e);
  reach.max.z = infinity;
  auto const ask = [&](auto const& cover) { return uncovered(field, cover, reach, [&] { return range; }); };
  if (g.is_flat) {
    double const z = reach.min.z = field.corners(g)[0].z;
    return ask(EdgeCover<A, Point3d>(field, {e.a.x, e.a.y, z}, {e.b.x, e.b.y, z}, side, column, true));
  }
  reach.min.z = -infinity;
  return ask(EdgeCover<Rational, Point3q>(field, top_over(field, g, e.a), top_over(field, g, e.b), side, column, true));
}

/// Whether the column ends at the line of an edge, on that side of it, with edges of its own.
template <Arithmetic A>
bool ends_with_edges(HeightField const& field, HeightField::TopEdge const& e, Sign side, std::uint32_t column)
{
  auto const turn = [&](Point3d const& p) { return orient2d<A>(horizontal(e.a), horizontal(e.b), horizontal(p)); };
  auto const on_line = [&](Point3d const& p, Point3d const& q) { return is_zero(turn(p)) && is_zero(turn(q)); };
  auto const corners = field.corners(field.columns()[column]);
  if (std::ranges::any_of(corners, [&](Point3d const& p) { return turn(p) == -side; })) return false;
  std::ptrdiff_t sides = 0;
  for (std::size_t i = corners.size() - 1, j = 0; j < corners.size(); i = j++) sides += on_line(corners[i], corners[j]);
  auto const edges = std::ranges::equal_range(field.edges(), column, {}, &HeightField::TopEdge::column);
  return sides == std::ranges::count_if(edges, [&](auto const& f) { return on_line(f.a, f.b); });
}

}  // namespace

template <Arithmetic A>
ExposedParts exposed_parts(HeightField const& field, std::uint32_t edge, Crossing crossing)
{
  auto const& e = field.edges()[edge];
  bool const sees_top = crossing == Crossing::leaving && !field.columns()[e.column].is_curtain();
  EdgeCover<A, Point3d> const cover(field, e.a, e.b, side_of(crossing), e.column, sees_top);
  Box reach = bounds_of(e);  // a column that is lower than the edge covers nothing
  reach.max.z = infinity;
  return uncovered(field, cover, reach, [] { return OpenInterval{0, 1}; });
}

template <Arithmetic A>
std::vector<Foot> exposed_feet(HeightField const& field, std::uint32_t edge, Crossing crossing)
{
  auto const& e = field.edges()[edge];
  Sign const side = side_of(crossing);
  EdgeCover<A, Point3d> const wall(field, e.a, e.b, side, e.column, false);
  Box reach = bounds_of(e);
  reach.min.z = -infinity;
  std::vector<Foot> feet;
  field.column_hierarchy().any_item_meeting(reach, [&](std::uint32_t column) {
    if (field.columns()[column].object == field.object_of(e)) return false;
    auto const lower = wall.lower(column);
    if (!lower || ends_with_edges<A>(field, e, side, column)) return false;
    OpenInterval const range{lower->low.value_or(0), lower->high.value_or(1)};
    auto top = top_beside<A>(field, e, side, column, range);
    if (top.all) top.parts = {range};
    if (!top.parts.empty()) feet.push_back({column, std::move(top.parts)});
    return false;
  });
  std::ranges::sort(feet, {}, &Foot::column);
  return feet;
}

template ExposedParts exposed_parts<Filtered>(HeightField const&, std::uint32_t, Crossing);
template ExposedParts exposed_parts<Rational>(HeightField const&, std::uint32_t, Crossing);
template std::vector<Foot> exposed_feet<Filtered>(HeightField const&, std::uint32_t, Crossing);
template std::vector<Foot> exposed_feet<Rational>(HeightField const&, std::uint32_t, Crossing);

}  // namespace visibility
