#pragma once

#include "visibility/methods/strong_occlusion/occluder_search.hpp"
#include "visibility/methods/strong_occlusion/options.hpp"
#include "visibility/scene/faces.hpp"
#include "visibility/scene/potentially_visible_set.hpp"

namespace visibility {

/// Strong occlusion: an object is hidden if one convex body blocks every sight line to it, or to each of its parts or
/// faces. Conservative: what is hidden by several bodies together is kept.
/// Takes any scene: boxes, prisms, polyhedra, balls and triangles are occluders, each on its own.
/// Source: [Cohen-Or98]; method and departures: docs/strong-occlusion.md.
template <Arithmetic A = Filtered>
class StrongOcclusion {
public:
  using Options = strong_occlusion::Options;

  StrongOcclusion() = default;
  explicit StrongOcclusion(Options options) : options_(options) {}

  /// The potentially visible set: `conservative` (`none` with `Double`). Statistics: targets, candidates, rays,
  /// groups_hidden.
  PotentiallyVisibleSet operator()(PreparedScene const& scene, ViewCell const& cell) const;

private:
  Options options_;
};

namespace strong_occlusion {

/// Whether no strong occluder was found for some face of the body at the given granularity.
template <Arithmetic A>
bool possibly_visible(OccluderSearch<A>& search, PreparedScene const& scene, ViewCell const& cell,
                      ConvexBodies::Body const& body, Box const& bounds, Granularity granularity)
{
  if (!certainly_disjoint(cell, bounds)) return true;
  std::vector<Point3d> target;
  scene.bodies().append_vertices(body, target);
  if (search.find(target)) return false;
  if (granularity != Granularity::face) return true;
  return any_face_towards(cell, scene.bodies(), body, [&](std::span<Point3d const> face) {
    target.assign(face.begin(), face.end());
    return !search.find(target);
  });
}

/// The same for a whole object.
template <Arithmetic A>
bool possibly_visible(OccluderSearch<A>& search, PreparedScene const& scene, ViewCell const& cell, std::uint32_t object,
                      Granularity granularity)
{
  Box const& box = scene.object_bounds()[object];
  if (certainly_disjoint(cell, box)) {
    auto const corners = box.corners();
    std::vector<Point3d> target(corners.begin(), corners.end());
    if (search.find(target)) return false;
  }
  if (granularity == Granularity::object) return true;
  auto const bodies = scene.bodies().bodies_of(object);
  auto const bounds = scene.bodies().bounds_of(object);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (possibly_visible(search, scene, cell, bodies[i], bounds[i], granularity)) return true;
  return false;
}

}  // namespace strong_occlusion

template <Arithmetic A>
PotentiallyVisibleSet StrongOcclusion<A>::operator()(PreparedScene const& scene, ViewCell const& cell) const
{
  strong_occlusion::OccluderSearch<A> search(scene, cell);
  PotentiallyVisibleSet result;
  result.guarantee = A::is_exact ? Guarantee::conservative : Guarantee::none;
  double groups_hidden = 0;
  auto const enter = [&](std::uint32_t, Box const& group) {
    if (!options_.groups || !certainly_disjoint(cell, group)) return true;
    auto const corners = group.corners();
    std::vector<Point3d> target(corners.begin(), corners.end());
    bool const hidden = search.find(target).has_value();
    groups_hidden += hidden;
    return !hidden;
  };
  auto const visit = [&](std::uint32_t object) {
    if (strong_occlusion::possibly_visible(search, scene, cell, object, options_.granularity))
      result.visible.push_back(object);
  };
  scene.object_hierarchy().front_to_back(cell.bounds(), enter, visit);
  std::ranges::sort(result.visible);
  result.statistics = {{"targets", double(search.counts().targets)},
                       {"candidates", double(search.counts().candidates)},
                       {"rays", double(search.counts().rays)},
                       {"groups_hidden", groups_hidden}};
  return result;
}

extern template class StrongOcclusion<Filtered>;
extern template class StrongOcclusion<Rational>;
extern template class StrongOcclusion<Double>;

}  // namespace visibility
