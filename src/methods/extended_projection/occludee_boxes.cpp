#include "visibility/methods/extended_projection/occludee_boxes.hpp"

#include <vector>

namespace visibility::extended_projection {

Box body_box(ConvexBodies const& bodies, std::size_t body, Frame const& frame)
{
  if (!frame.is_turned()) return frame(bodies.bounds()[body]);
  thread_local std::vector<Point3d> vertices;
  vertices.clear();
  bodies.append_vertices(bodies.bodies()[body], vertices);
  Box out;
  for (auto const& p : vertices) out.extend(frame(Box{p, p}));
  return out;
}

Box object_box(PreparedScene const& scene, std::uint32_t object, Frame const& frame)
{
  auto const first = scene.bodies().first_of_object()[object], last = scene.bodies().first_of_object()[object + 1];
  if (!frame.is_turned() || last - first > most_occludee_bodies) return frame(scene.object_bounds()[object]);
  Box out;
  for (auto b = first; b < last; ++b) out.extend(body_box(scene.bodies(), b, frame));
  return out;
}

}  // namespace visibility::extended_projection
