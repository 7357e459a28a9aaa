#include "visibility/scene/height_field.hpp"

#include "height_field_columns.hpp"
#include "wall_cover.hpp"

#include "visibility/scene/scene_builder.hpp"
#include "visibility/scene/seams.hpp"

#include <algorithm>

namespace visibility {

namespace {

/// Down to the bottom of the column or curtain.
Box bounds_of(std::span<Point3d const> points)
{
  Box b;
  for (auto const& p : points) b.extend(p);
  b.min.z = std::min(HeightField::bottomless, 2 * b.min.z);
  return b;
}

/// Whether a box stands on the ground, or on another one of the object that does.
bool is_supported(Scene const& scene, Object const& object, Box const& box, double ground)
{
  if (box.min.z <= ground) return true;
  for (auto i = object.boxes.first; i < object.boxes.last; ++i) {
    Box const& b = scene.boxes[i];
    if (b.min.x <= box.min.x && box.max.x <= b.max.x && b.min.y <= box.min.y && box.max.y <= b.max.y &&
        b.max.z >= box.min.z && b.min.z < box.min.z && is_supported(scene, object, b, ground))
      return true;
  }
  return false;
}

/// Whether a box or prism of the object ends above the ground.
bool has_raised_solid(Scene const& scene, Object const& object, double ground)
{
  for (auto i = object.boxes.first; i < object.boxes.last; ++i)
    if (!is_supported(scene, object, scene.boxes[i], ground)) return true;
  for (auto i = object.prisms.first; i < object.prisms.last; ++i)
    if (scene.prisms[i].bottom > ground) return true;
  return false;
}

}  // namespace

HeightField::HeightField(Scene const& scene) : scene_(&scene)
{
  if (!scene.balls.empty()) {
    auto const it = std::ranges::find_if(scene.objects, [](Object const& o) { return o.balls.size() > 0; });
    throw BadInput("object '" + it->name + "' is a ball, which has no top edges: exact-2.5d takes boxes, prisms, " +
                   "convex solids and triangles");
  }
  for (auto const& o : scene.objects)
    if (!o.occludes)
      throw BadInput("object '" + o.name + "' hides nothing, and a height field is what hides: give it as an occludee");
  ground_ = bounding_box(scene).min.z;
  height_field::ObjectColumns builder(scene);
  std::vector<Box> edge_bounds, column_bounds;
  for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
    auto const& object = scene.objects[o];
    auto const& parts = builder.of(object);
    raised_ += has_raised_solid(scene, object, ground_) || height_field::WallCover(parts, ground_).has_open_wall();
    invalid_footprints_ += parts.invalid_footprints;
    auto const base = static_cast<std::uint32_t>(columns_.size());
    for (auto const& c : parts.columns) {
      auto const first = static_cast<std::uint32_t>(corners_.size());
      bool const flat = std::ranges::all_of(c, [&](Point3d const& p) { return p.z == c.front().z; });
      corners_.insert(corners_.end(), c.begin(), c.end());
      columns_.push_back({first, static_cast<std::uint32_t>(c.size()), o, flat});
      column_bounds.push_back(bounds_of(c));
    }
    for (auto const& e : parts.edges) {
      edges_.push_back({e.a, e.b, base + e.column});
      edge_bounds.push_back(bounds_of(std::array{e.a, e.b}));
    }
  }
  edge_hierarchy_ = BoundingHierarchy(edge_bounds);
  column_hierarchy_ = BoundingHierarchy(column_bounds);
  seams_ = find_seams(*this);
  // Most are covered all along, which every query would find out again.
  std::erase_if(seams_, [&](Seam const& s) { return exposed_parts(*this, s).empty(); });
  seam_bounds_.reserve(seams_.size());
  for (auto const& s : seams_) seam_bounds_.push_back(bounds(*this, s));
  seam_hierarchy_ = BoundingHierarchy(seam_bounds_);
}

}  // namespace visibility
