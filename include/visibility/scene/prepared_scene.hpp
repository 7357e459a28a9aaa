#pragma once

#include "visibility/scene/bounding_hierarchy.hpp"
#include "visibility/scene/convex_bodies.hpp"

namespace visibility {

/// A scene with what queries from any cell share: its convex bodies and hierarchies over bodies and objects. Built
/// once; const afterwards, so queries may run in parallel. Keeps a reference to the scene, which must outlive it.
class PreparedScene {
public:
  explicit PreparedScene(Scene const& scene)
    : bodies_(scene), object_bounds_(bounds_of_objects(bodies_)), object_hierarchy_(object_bounds_),
      body_hierarchy_(object_hierarchy_, bodies_.first_of_object(), bodies_.bounds())
  {
  }

  Scene const& scene() const { return bodies_.scene(); }
  ConvexBodies const& bodies() const { return bodies_; }
  std::span<Box const> object_bounds() const { return object_bounds_; }            ///< outward, one per object
  BoundingHierarchy const& object_hierarchy() const { return object_hierarchy_; }  ///< items: positions in objects
  /// Items: positions in bodies(). The object hierarchy carried further: node i there holds the objects of which node i
  /// here holds the bodies.
  BoundingHierarchy const& body_hierarchy() const { return body_hierarchy_; }

private:
  static std::vector<Box> bounds_of_objects(ConvexBodies const& bodies)
  {
    std::vector<Box> out(bodies.scene().objects.size());
    for (std::size_t i = 0; i < bodies.bodies().size(); ++i) out[bodies.bodies()[i].object].extend(bodies.bounds()[i]);
    return out;
  }

  ConvexBodies bodies_;
  std::vector<Box> object_bounds_;
  BoundingHierarchy object_hierarchy_, body_hierarchy_;
};

}  // namespace visibility
