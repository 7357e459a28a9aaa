#include "visibility/scene/occluders.hpp"

#include <utility>

namespace visibility {

Occluders::Occluders(ConvexBodies const& bodies, InnerBodyOptions const& options) : bodies_(&bodies)
{
  Scene const& scene = bodies.scene();
  auto const count = static_cast<std::uint32_t>(bodies.bodies().size());
  std::vector<std::uint32_t> loose;
  for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
    first_of_object_.push_back(static_cast<std::uint32_t>(all_.size()));
    loose.clear();
    for (auto b = bodies.first_of_object()[o]; b < bodies.first_of_object()[o + 1]; ++b) {
      all_.push_back(b);
      bounds_.push_back(bodies.bounds()[b]);
      auto const& body = bodies.bodies()[b];
      if (body.kind == ConvexBodies::Kind::triangle) loose.push_back(body.index);
    }
    for (auto& inner : inner_bodies(scene, scene.objects[o], loose, options)) {
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
