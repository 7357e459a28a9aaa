#include "visibility/scene/occluders.hpp"

#include <numeric>
#include <utility>

namespace visibility {

Occluders::Occluders(ConvexBodies const& bodies, InnerBodyOptions const& options) : bodies_(&bodies)
{
  Scene const& scene = bodies.scene();
  auto const count = static_cast<std::uint32_t>(bodies.bodies().size());
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
    first_of_object_.push_back(static_cast<std::uint32_t>(all_.size()));
    for (auto b = bodies.first_of_object()[o]; b < bodies.first_of_object()[o + 1]; ++b) {
      all_.push_back(b);
      bounds_.push_back(bodies.bounds()[b]);
    }
    Object const& object = scene.objects[o];
    if (!object.occludes || bodies.bodies_of(o).size() < 2) continue;  // hides nothing, or convex already
    // All triangles, those of convex solids too: storeys that are solids of their own may make a tower.
    triangles.resize(object.triangles.size());
    std::iota(triangles.begin(), triangles.end(), object.triangles.first);
    for (auto& inner : inner_bodies(scene, object, triangles, options)) {
      all_.push_back(count + static_cast<std::uint32_t>(inner_.size()));
      bounds_.push_back(bounding_box(inner));
      inner_.push_back(std::move(inner));
      inner_owner_.push_back(o);
    }
  }
  first_of_object_.push_back(static_cast<std::uint32_t>(all_.size()));
  if (!inner_.empty()) return;
  all_.clear();
  bounds_.clear();
  first_of_object_.clear();
}

}  // namespace visibility
