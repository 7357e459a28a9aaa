#include "visibility/scene/moving_objects.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <unordered_set>

namespace visibility {

namespace {

/// Appends one array's share of an object to another scene.
template <class T>
IndexRange carry(std::vector<T> const& from, IndexRange const& range, std::vector<T>& to)
{
  auto const first = static_cast<std::uint32_t>(to.size());
  to.insert(to.end(), from.begin() + range.first, from.begin() + range.last);
  return {first, static_cast<std::uint32_t>(to.size())};
}

std::uint64_t primitives(Object const& o)
{
  return std::uint64_t{o.boxes.size()} + o.balls.size() + o.prisms.size() + o.polyhedra.size() + o.triangles.size();
}

}  // namespace

Scene with_moving_objects(Scene scene, std::span<MovingObject const> moving)
{
  if (moving.empty()) return scene;
  SceneBuilder builder(scene.source);
  for (auto const& m : moving) {
    builder.begin_occludee(m.name);
    builder.add(m.region);
  }
  Scene regions = builder.finish();
  std::unordered_set<std::string> names;
  for (auto const& o : scene.objects) names.insert(o.name);
  for (auto& o : regions.objects) {
    if (names.contains(o.name))
      throw BadInput("moving object '" + o.name + "': the scene has an object of that name already; rename it");
    o.boxes = carry(regions.boxes, o.boxes, scene.boxes);
    o.balls = carry(regions.balls, o.balls, scene.balls);
    o.prisms = carry(regions.prisms, o.prisms, scene.prisms);
    o.polyhedra = carry(regions.polyhedra, o.polyhedra, scene.polyhedra);
    o.triangles = carry(regions.triangles, o.triangles, scene.triangles);
    scene.objects.push_back(std::move(o));
  }
  return scene;
}

std::pair<Scene, Scene> split(Scene const& scene)
{
  std::pair<Scene, Scene> out;
  for (auto* const part : {&out.first, &out.second}) {
    part->source = scene.source;
    part->notes = scene.notes;
    part->vertices = scene.vertices;
  }
  for (auto const& o : scene.objects) {
    Scene& part = o.occludes ? out.first : out.second;
    part.objects.push_back({o.name, carry(scene.boxes, o.boxes, part.boxes), carry(scene.balls, o.balls, part.balls),
                            carry(scene.prisms, o.prisms, part.prisms),
                            carry(scene.polyhedra, o.polyhedra, part.polyhedra),
                            carry(scene.triangles, o.triangles, part.triangles), o.occludes});
  }
  return out;
}

std::vector<std::uint64_t> polygon_counts(Scene const& with_moving, std::span<MovingObject const> moving)
{
  std::vector<std::uint64_t> out;
  for (auto const& o : with_moving.objects) out.push_back(primitives(o));
  std::size_t const first = out.size() - moving.size();
  for (std::size_t i = 0; i < moving.size(); ++i) out[first + i] = moving[i].polygons;
  return out;
}

}  // namespace visibility
