#pragma once

#include "visibility/scene/bounding_hierarchy.hpp"
#include "visibility/scene/convex_bodies.hpp"
#include "visibility/scene/enclosing_shells.hpp"
#include "visibility/scene/ground_level.hpp"
#include "visibility/scene/object_outlines.hpp"
#include "visibility/scene/occluders.hpp"

#include <optional>

namespace visibility {

/// A scene with what queries from any cell share: its convex bodies, its occluders, and hierarchies over them and over
/// the objects. Built once; const afterwards, so queries may run in parallel. Keeps a reference to the scene, which
/// must outlive it; stays where it is.
class PreparedScene {
public:
  explicit PreparedScene(Scene const& scene) : PreparedScene(scene, nullptr) {}
  /// With convex bodies inside non-convex objects as additional occluders: for methods in which one body at a time
  /// occludes. Finding them takes longer than all the rest; a scene of boxes and convex solids has none.
  PreparedScene(Scene const& scene, InnerBodyOptions const& options) : PreparedScene(scene, &options) {}
  PreparedScene(PreparedScene const&) = delete;
  PreparedScene& operator=(PreparedScene const&) = delete;

  Scene const& scene() const { return bodies_.scene(); }
  ConvexBodies const& bodies() const { return bodies_; }
  Occluders const& occluders() const { return occluders_; }
  /// What closed meshes enclose; none unless inner bodies were asked for.
  EnclosingShells const& shells() const { return shells_; }
  std::span<Box const> object_bounds() const { return object_bounds_; }  ///< outward, one per object
  ObjectOutlines const& object_outlines() const { return object_outlines_; }
  double ground() const { return ground_; }                                        ///< ground_level() of the objects
  BoundingHierarchy const& object_hierarchy() const { return object_hierarchy_; }  ///< items: positions in objects
  /// Items: positions in bodies(). The object hierarchy carried further: node i there holds the objects of which node i
  /// here holds the bodies.
  BoundingHierarchy const& body_hierarchy() const { return body_hierarchy_; }
  /// The same over occluders().
  BoundingHierarchy const& occluder_hierarchy() const
  {
    return occluder_hierarchy_ ? *occluder_hierarchy_ : body_hierarchy_;
  }

private:
  PreparedScene(Scene const& scene, InnerBodyOptions const* options)
    : bodies_(scene), shells_(options != nullptr && options->shells ? EnclosingShells(bodies_, options->max_triangles)
                                                                    : EnclosingShells()),
      occluders_(options != nullptr ? Occluders(bodies_, *options) : Occluders(bodies_)),
      object_bounds_(bounds_of_objects(bodies_)), ground_(ground_level(object_bounds_)), object_outlines_(bodies_),
      object_hierarchy_(object_bounds_), body_hierarchy_(object_hierarchy_, bodies_.first_of_object(), bodies_.bounds())
  {
    if (occluders_.inner_count() > 0)
      occluder_hierarchy_.emplace(object_hierarchy_, occluders_.first_of_object(), occluders_.bounds());
  }

  static std::vector<Box> bounds_of_objects(ConvexBodies const& bodies)
  {
    std::vector<Box> out(bodies.scene().objects.size());
    for (std::size_t i = 0; i < bodies.bodies().size(); ++i) out[bodies.bodies()[i].object].extend(bodies.bounds()[i]);
    return out;
  }

  ConvexBodies bodies_;
  EnclosingShells shells_;
  Occluders occluders_;
  std::vector<Box> object_bounds_;
  double ground_;
  ObjectOutlines object_outlines_;
  BoundingHierarchy object_hierarchy_, body_hierarchy_;
  std::optional<BoundingHierarchy> occluder_hierarchy_;
};

}  // namespace visibility
