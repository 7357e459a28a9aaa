#pragma once

#include "visibility/predicates/orient2d.hpp"
#include "visibility/predicates/orient3d.hpp"
#include "visibility/scene/convex_bodies.hpp"
#include "visibility/scene/view_cell.hpp"

#include <algorithm>

namespace visibility {

namespace detail {

/// Whether every cell vertex lies on the inner side of, or on, the plane abc, seen counterclockwise from outside.
inline bool faces_away(ViewCell const& cell, Point3d const& a, Point3d const& b, Point3d const& c)
{
  return std::ranges::none_of(cell.vertices(),
                              [&](Point3d const& v) { return is_positive(orient3d<Filtered>(a, b, c, v)); });
}

template <class Visit>
bool any_box_face(ViewCell const& cell, Box const& box, Visit&& visit)
{
  Box const& seen_from = cell.bounds();
  auto const face = [&](int bit, bool high) {
    // The four corners with this bit fixed.
    std::array<Point3d, 4> corners;
    int const a = bit == 1 ? 2 : 1, b = bit == 4 ? 2 : 4, base = high ? bit : 0;
    corners = {box.corner(base), box.corner(base | a), box.corner(base | a | b), box.corner(base | b)};
    return visit(std::span<Point3d const>(corners));
  };
  return (seen_from.min.x < box.min.x && face(1, false)) || (seen_from.max.x > box.max.x && face(1, true)) ||
         (seen_from.min.y < box.min.y && face(2, false)) || (seen_from.max.y > box.max.y && face(2, true)) ||
         (seen_from.min.z < box.min.z && face(4, false)) || (seen_from.max.z > box.max.z && face(4, true));
}

template <class Visit>
bool any_prism_face(ViewCell const& cell, ConvexPrism const& prism, Visit&& visit)
{
  std::size_t const n = prism.footprint.size();
  for (std::size_t i = 0; i < n; ++i) {
    auto const &a = prism.footprint[i], &b = prism.footprint[(i + 1) % n];
    bool const away = std::ranges::none_of(
      cell.vertices(), [&](Point3d const& v) { return is_negative(orient2d<Filtered>(a, b, horizontal(v))); });
    if (away) continue;
    std::array<Point3d, 4> const wall{Point3d{a.x, a.y, prism.top}, Point3d{b.x, b.y, prism.top},
                                      Point3d{b.x, b.y, prism.bottom}, Point3d{a.x, a.y, prism.bottom}};
    if (visit(std::span<Point3d const>(wall))) return true;
  }
  auto const cap = [&](double z) {
    std::vector<Point3d> vertices;
    for (auto const& v : prism.footprint) vertices.push_back({v.x, v.y, z});
    return visit(std::span<Point3d const>(vertices));
  };
  return (cell.bounds().max.z > prism.top && cap(prism.top)) ||
         (cell.bounds().min.z < prism.bottom && cap(prism.bottom));
}

}  // namespace detail

/// Whether the body is looked at through its faces, polygons. A ball, a prism whose footprint is none and whatever does
/// not occlude are looked at as a whole.
inline bool has_polygons(ConvexBodies::Body const& body)
{
  return body.kind != ConvexBodies::Kind::ball && body.occludes;
}

/// Calls visit(vertices) for the faces of a body, each a convex polygon given by its vertices in order around it (one
/// way or the other), until visit returns true; returns whether it did. Left out are the faces of solids that have the
/// whole cell behind their plane: the body itself hides them, since a sight line from the cell's interior to the face's
/// relative interior runs through the body before it arrives. A body that does not occlude hides none of its faces: it
/// is visited once, as points whose hull contains it; so is a ball, as its bounding box.
template <class Visit>
bool any_face_towards(ViewCell const& cell, ConvexBodies const& scene, ConvexBodies::Body const& body, Visit&& visit)
{
  using Kind = ConvexBodies::Kind;
  switch (body.occludes ? body.kind : Kind::ball) {
  case Kind::box: return detail::any_box_face(cell, scene.box(body), visit);
  case Kind::prism: return detail::any_prism_face(cell, scene.prism(body), visit);
  case Kind::polyhedron: {
    auto const& p = scene.polyhedron(body);
    return std::ranges::any_of(p.facets, [&](ConvexPolyhedron::Facet const& f) {
      std::array<Point3d, 3> const t{p.vertices[f.vertices[0]], p.vertices[f.vertices[1]], p.vertices[f.vertices[2]]};
      return !detail::faces_away(cell, t[0], t[1], t[2]) && visit(std::span<Point3d const>(t));
    });
  }
  case Kind::ball:
  case Kind::triangle: break;
  }
  std::vector<Point3d> vertices;
  scene.append_vertices(body, vertices);
  return visit(std::span<Point3d const>(vertices));
}

}  // namespace visibility
