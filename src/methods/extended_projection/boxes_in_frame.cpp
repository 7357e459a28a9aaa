#include "visibility/methods/extended_projection/boxes_in_frame.hpp"

#include "visibility/geometry/shape_vertices.hpp"

#include <type_traits>
#include <vector>

namespace visibility::extended_projection {

namespace {

Box box_around(std::vector<Point3d> const& points, Frame const& frame)
{
  Box out;
  for (auto const& p : points) out.extend(frame.around(p));
  return out;
}

}  // namespace

Box body_box(ConvexBodies const& bodies, std::size_t body, Frame const& frame)
{
  if (!frame.is_turned()) return frame(bodies.bounds()[body]);
  thread_local std::vector<Point3d> vertices;
  vertices.clear();
  bodies.append_vertices(bodies.bodies()[body], vertices);
  return box_around(vertices, frame);
}

Box occluder_box(Occluders const& occluders, std::uint32_t occluder, Frame const& frame)
{
  if (!frame.is_turned()) return frame(occluders.bounds()[occluder]);
  thread_local std::vector<Point3d> vertices;
  vertices.clear();
  occluders.visit(occluder, [&](auto const& shape) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(shape)>, Ball>)
      append_vertices(occluders.bounds()[occluder], vertices);
    else
      append_vertices(shape, vertices);
  });
  return box_around(vertices, frame);
}

Box object_box(PreparedScene const& scene, std::uint32_t object, Frame const& frame)
{
  auto const first = scene.bodies().first_of_object()[object], last = scene.bodies().first_of_object()[object + 1];
  Box const& bounds = scene.object_bounds()[object];
  if (!frame.is_turned()) return frame(bounds);
  Box out;
  if (last - first > most_occludee_bodies) {
    for (auto const& p : scene.object_outlines().of(object))
      for (double const z : {bounds.min.z, bounds.max.z}) out.extend(frame.around({p.x, p.y, z}));
    return out;
  }
  for (auto b = first; b < last; ++b) out.extend(body_box(scene.bodies(), b, frame));
  return out;
}

}  // namespace visibility::extended_projection
