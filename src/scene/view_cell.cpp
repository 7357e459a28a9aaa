#include "visibility/scene/view_cell.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <stdexcept>

namespace visibility {

namespace {

template <Arithmetic A, class NT>
bool strictly_inside(ConvexPolyhedron const& shape, Point3<NT> const& p)
{
  return std::ranges::all_of(shape.facets, [&](ConvexPolyhedron::Facet const& f) {
    auto const v = [&](std::size_t i) { return detail::as<NT>(shape.vertices[f.vertices[i]]); };
    return is_negative(orient3d<A>(v(0), v(1), v(2), p));
  });
}

}  // namespace

ViewCell::ViewCell(Box const& box)
{
  if (!is_finite(box.min) || !is_finite(box.max)) throw std::invalid_argument("a cell coordinate is not finite");
  if (!box.has_interior())
    throw std::invalid_argument("the cell has no interior (min must be below max on every axis)");
  shape_ = ConvexPolyhedron::from_box(box);
  bounds_ = box;
  is_box_ = true;
}

ViewCell ViewCell::hull(std::span<Point3d const> points)
{
  if (points.size() < 4) throw std::invalid_argument("the cell has fewer than four vertices");
  ViewCell cell;
  cell.shape_ = ConvexPolyhedron::hull(points);
  cell.bounds_ = bounding_box(cell.shape_);
  auto const corners = cell.bounds_.corners();
  cell.is_box_ = cell.shape_.vertices.size() == 8 && std::ranges::all_of(cell.shape_.vertices, [&](Point3d const& v) {
                   return std::ranges::find(corners, v) != corners.end();
                 });
  return cell;
}

bool in_interior(ViewCell const& cell, Point3d const& p)
{
  Box const& b = cell.bounds();
  bool const inside =
    b.min.x < p.x && p.x < b.max.x && b.min.y < p.y && p.y < b.max.y && b.min.z < p.z && p.z < b.max.z;
  return inside && (cell.is_box() || strictly_inside<Filtered>(cell.shape(), p));
}

bool in_interior(ViewCell const& cell, Point3q const& p) { return strictly_inside<Rational>(cell.shape(), p); }

bool contains(ViewCell const& cell, Point3d const& p)
{
  auto const& shape = cell.shape();
  return contains(cell.bounds(), p) && std::ranges::none_of(shape.facets, [&](ConvexPolyhedron::Facet const& f) {
           auto const& v = f.vertices;
           return is_positive(orient3d<Filtered>(shape.vertices[v[0]], shape.vertices[v[1]], shape.vertices[v[2]], p));
         });
}

bool certainly_disjoint(ViewCell const& cell, Box const& box)
{
  if (!meet(cell.bounds(), box)) return true;
  if (cell.is_box()) return false;
  auto const corners = box.corners();
  auto const& shape = cell.shape();
  return std::ranges::any_of(shape.facets, [&](ConvexPolyhedron::Facet const& f) {
    return std::ranges::all_of(corners, [&](Point3d const& c) {
      return is_positive(orient3d<Filtered>(shape.vertices[f.vertices[0]], shape.vertices[f.vertices[1]],
                                            shape.vertices[f.vertices[2]], c));
    });
  });
}

}  // namespace visibility
