#pragma once

#include "visibility/methods/strong_occlusion/object_visibility.hpp"

namespace visibility::strong_occlusion {

/// What the tables of [CohenOr98, 6] count: every body looked at, and every polygon of a body that is not hidden as a
/// whole, where the method itself stops at the first that is visible.
struct Survey {
  std::uint64_t bodies = 0;
  std::uint64_t hidden_bodies = 0;     ///< one strong occluder for the whole body
  std::uint64_t hidden_piecewise = 0;  ///< those, and bodies each of whose polygons has a strong occluder
  std::uint64_t visible_polygons = 0;  ///< triangles without a strong occluder that face the cell; a ball counts as one
  Counts counts;
};

/// Surveys a scene from one cell. Polygons are the triangles of faces that look towards the cell. `options.granularity`
/// and `visible_first` do not apply. Exact if the arithmetic is.
template <Arithmetic A>
Survey survey(PreparedScene const& scene, ViewCell const& cell, Options const& options)
{
  Remainder const remainder(scene);
  OccluderSearch<A> search(remainder, cell, options);
  ConvexBodies const& bodies = scene.bodies();
  Survey out;
  out.bodies = bodies.bodies().size();
  std::vector<Point3d> vertices;

  std::uint64_t looked_at = 0;
  auto const look_at = [&](Remainder::Item item, ConvexBodies::Body const& body) {
    ++looked_at;
    Box const& bounds = remainder.bounds(item);
    bool const disjoint = certainly_disjoint(cell, bounds);
    vertices.clear();
    bodies.append_vertices(body, vertices);
    Target target = target_of(vertices);
    target.is_box = body.kind == ConvexBodies::Kind::box;
    if (disjoint && search.find(target)) {
      search.hide(item);
      ++out.hidden_bodies;
      return;
    }
    std::uint64_t visible = 0;
    any_face_towards(cell, bodies, body, [&](std::span<Point3d const> face) {
      if (!has_polygons(body)) {
        ++visible;  // its box, for which no occluder was found
        return false;
      }
      for (std::size_t i = 2; i < face.size(); ++i) {
        std::array<Point3d, 3> const triangle{face[0], face[i - 1], face[i]};
        visible += !disjoint || !search.find_for_face(target_of(triangle));
      }
      return false;
    });
    out.visible_polygons += visible;
    out.hidden_piecewise += disjoint && visible == 0;
  };
  scene.object_hierarchy().front_to_back(
    cell.bounds(),
    [&](std::uint32_t node, Box const& box) {
      if (!options.groups || !certainly_disjoint(cell, box) || !search.find(BoxTarget(box).target())) return true;
      search.hide_node(node);
      return false;
    },
    [&](Remainder::Item object) {
      auto const [first, last] = remainder.occluders_of(object);
      for (auto i = first; i < last; ++i)
        if (auto const* const body = remainder.body(i)) look_at(i, *body);
    });
  out.hidden_bodies += out.bodies - looked_at;  // in groups dropped whole
  out.hidden_piecewise += out.hidden_bodies;
  out.counts = search.counts();
  return out;
}

}  // namespace visibility::strong_occlusion
