#pragma once

#include "visibility/evidence/coordinate.hpp"
#include "visibility/scene/prepared_scene.hpp"

namespace visibility {

namespace detail {

/// Bounds of every point within one rounding of the box: what encloses a rounded point's neighbourhood.
class ProbeMargin {
public:
  ProbeMargin() = default;  ///< none: the probe's ends are exact
  /// Room for ends whose coordinates were rounded, in any direction, by at most one unit in the last place.
  ProbeMargin(Point3d const& p, Point3d const& q) : x_(margin(p.x, q.x)), y_(margin(p.y, q.y)), z_(margin(p.z, q.z)) {}
  Box enlarge(Box const& b) const
  {
    if (x_ == 0) return b;
    return {{down(b.min.x, x_), down(b.min.y, y_), down(b.min.z, z_)},
            {up(b.max.x, x_), up(b.max.y, y_), up(b.max.z, z_)}};
  }

private:
  static double margin(double a, double b) { return 0x1p-51 * std::max(std::fabs(a), std::fabs(b)) + 0x1p-1060; }
  static double down(double v, double m) { return std::nextafter(v - m, -HUGE_VAL); }
  static double up(double v, double m) { return std::nextafter(v + m, HUGE_VAL); }
  double x_ = 0, y_ = 0, z_ = 0;
};

inline Point3d rounded(Point3d const& p) { return p; }
inline Point3d rounded(Point3q const& p) { return {CGAL::to_double(p.x), CGAL::to_double(p.y), CGAL::to_double(p.z)}; }
inline Point3d rounded(Point3<Coordinate> const& p) { return {p.x.below(), p.y.below(), p.z.below()}; }

}  // namespace detail

/// The occluding body, as a position in bodies(), that the half-open segment [from, to) meets; empty: the line is free.
/// Exact. Requires: from != to. Bodies that do not occlude block nothing.
template <Arithmetic A, class NT>
std::optional<std::uint32_t> blocker(PreparedScene const& scene, Point3<NT> const& from, Point3<NT> const& to)
{
  Point3d const p = detail::rounded(from), q = detail::rounded(to);
  detail::ProbeMargin const margin = std::same_as<NT, double> ? detail::ProbeMargin() : detail::ProbeMargin(p, q);
  SegmentProbe const probe(p, q);
  auto const missed = [&](Box const& b) { return probe.certainly_misses(margin.enlarge(b)); };

  BoundingHierarchy const& tree = scene.body_hierarchy();
  ConvexBodies const& bodies = scene.bodies();
  thread_local std::vector<std::uint32_t> stack;
  stack.assign(tree.nodes().empty() ? 0 : 1, 0);
  while (!stack.empty()) {
    auto const& node = tree.nodes()[stack.back()];
    stack.pop_back();
    if (missed(node.bounds)) continue;
    if (!node.is_leaf()) {
      stack.push_back(node.first + 1);
      stack.push_back(node.first);
      continue;
    }
    for (auto const i : tree.items().subspan(node.first, node.count)) {
      auto const& body = bodies.bodies()[i];
      if (body.occludes && !missed(bodies.bounds()[i]) && segment_meets<A, End::excluded>(bodies, body, from, to))
        return i;
    }
  }
  return {};
}

}  // namespace visibility
