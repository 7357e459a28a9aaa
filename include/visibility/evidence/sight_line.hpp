#pragma once

#include "visibility/kernel/enclosed_rational.hpp"
#include "visibility/scene/prepared_scene.hpp"

namespace visibility {

namespace detail {

inline EnclosingProbe enclosing_probe(Point3d const& p, Point3d const& q) { return {p, q}; }
inline EnclosingProbe enclosing_probe(Point3q const& p, Point3q const& q) { return {p, q}; }
inline EnclosingProbe enclosing_probe(Point3<EnclosedRational> const& p, Point3<EnclosedRational> const& q)
{
  auto const below = [](Point3<EnclosedRational> const& r) { return Point3d{r.x.low(), r.y.low(), r.z.low()}; };
  return EnclosingProbe::around(below(p), below(q));
}

}  // namespace detail

/// The occluding body, as a position in bodies(), that the half-open segment [from, to) meets; empty: the line is free.
/// Exact. Requires: from != to. Bodies that do not occlude block nothing.
template <Arithmetic A, class NT>
std::optional<std::uint32_t> blocker(PreparedScene const& scene, Point3<NT> const& from, Point3<NT> const& to)
{
  EnclosingProbe const probe = detail::enclosing_probe(from, to);

  BoundingHierarchy const& tree = scene.body_hierarchy();
  ConvexBodies const& bodies = scene.bodies();
  thread_local std::vector<std::uint32_t> stack;
  stack.assign(tree.nodes().empty() ? 0 : 1, 0);
  while (!stack.empty()) {
    auto const& node = tree.nodes()[stack.back()];
    stack.pop_back();
    if (probe.certainly_misses(node.bounds)) continue;
    if (!node.is_leaf()) {
      stack.push_back(node.first + 1);
      stack.push_back(node.first);
      continue;
    }
    for (auto const i : tree.items().subspan(node.first, node.count)) {
      auto const& body = bodies.bodies()[i];
      if (body.occludes && !probe.certainly_misses(bodies.bounds()[i]) &&
          segment_meets<A, End::excluded>(bodies, body, from, to))
        return i;
    }
  }
  return {};
}

}  // namespace visibility
