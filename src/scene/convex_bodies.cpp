#include "visibility/scene/convex_bodies.hpp"

#include "mesh_pieces.hpp"

#include "visibility/geometry/shape_vertices.hpp"

#include <type_traits>

namespace visibility {

ConvexBodies::ConvexBodies(Scene const& scene) : scene_(&scene)
{
  first_body_.reserve(scene.objects.size() + 1);
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    Object const& o = scene.objects[id];
    first_body_.push_back(static_cast<std::uint32_t>(bodies_.size()));
    for (auto i = o.boxes.first; i < o.boxes.last; ++i) add({id, i, Kind::box, o.occludes}, scene.boxes[i]);
    for (auto i = o.balls.first; i < o.balls.last; ++i)
      add({id, i, Kind::ball, o.occludes}, visibility::bounding_box(scene.balls[i]));
    for (auto i = o.prisms.first; i < o.prisms.last; ++i) {
      auto pieces = convex_partition(scene.prisms[i]);
      if (pieces.empty()) {
        ++invalid_footprints_;
        stand_ins_.push_back(visibility::bounding_box(scene.prisms[i]));
        add({id, static_cast<std::uint32_t>(scene.boxes.size() + stand_ins_.size() - 1), Kind::box, false},
            stand_ins_.back());
      }
      for (auto& piece : pieces) {
        Box const bounds = visibility::bounding_box(piece);
        prisms_.push_back(std::move(piece));
        add({id, static_cast<std::uint32_t>(prisms_.size() - 1), Kind::prism, o.occludes}, bounds);
      }
    }
    for (auto i = o.polyhedra.first; i < o.polyhedra.last; ++i)
      add({id, i, Kind::polyhedron, o.occludes}, visibility::bounding_box(scene.polyhedra[i]));
    if (o.triangles.size() == 0) continue;
    auto pieces = detail::mesh_pieces(scene, o.triangles);
    for (auto& piece : pieces.convex) {
      Box const bounds = visibility::bounding_box(piece);
      mesh_pieces_.push_back(std::move(piece));
      add({id, static_cast<std::uint32_t>(scene.polyhedra.size() + mesh_pieces_.size() - 1), Kind::polyhedron,
           o.occludes},
          bounds);
    }
    for (auto const i : pieces.loose)
      add({id, i, Kind::triangle, o.occludes}, visibility::bounding_box(scene.triangle(i)));
  }
  first_body_.push_back(static_cast<std::uint32_t>(bodies_.size()));
}

void ConvexBodies::add(Body body, Box const& bounds)
{
  bodies_.push_back(body);
  bounds_.push_back(bounds);
}

std::span<ConvexBodies::Body const> ConvexBodies::bodies_of(std::uint32_t object) const
{
  return bodies().subspan(first_body_[object], first_body_[object + 1] - first_body_[object]);
}

std::span<Box const> ConvexBodies::bounds_of(std::uint32_t object) const
{
  return bounds().subspan(first_body_[object], first_body_[object + 1] - first_body_[object]);
}

void ConvexBodies::append_vertices(Body const& b, std::vector<Point3d>& out) const
{
  visit_shape(*this, b, [&](auto const& shape) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(shape)>, Ball>)
      visibility::append_vertices(visibility::bounding_box(shape), out);
    else
      visibility::append_vertices(shape, out);
  });
}

}  // namespace visibility
