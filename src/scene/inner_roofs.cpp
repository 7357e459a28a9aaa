#include "inner_roofs.hpp"

#include "inner_certificate.hpp"
#include "plan.hpp"

#include <algorithm>
#include <stdexcept>

namespace visibility::detail {

namespace {

void append_corners(ConvexPrism const& k, std::vector<Point3d>& out)
{
  for (auto const& p : k.footprint)
    for (double const z : {k.bottom, k.top}) out.push_back({p.x, p.y, z});
}

/// The certified hull of the points moved towards their mean by a part of their distance; those at the height `foot`
/// only sideways.
std::optional<ConvexPolyhedron> certified_hull(MeshShell const& shell, std::vector<Point3d> const& points, double foot,
                                               double by)
{
  Point3d c{0, 0, 0};
  double const n = static_cast<double>(points.size());
  for (auto const& p : points) c = {c.x + p.x / n, c.y + p.y / n, c.z + p.z / n};
  std::vector<Point3d> moved;
  for (auto const& p : points)
    moved.push_back({p.x + by * (c.x - p.x), p.y + by * (c.y - p.y), p.z == foot ? foot : p.z + by * (c.z - p.z)});
  try {
    auto body = ConvexPolyhedron::hull(moved);
    if (is_certified(shell, body)) return body;
  } catch (std::invalid_argument const&) {
    // flat
  }
  return {};
}

/// The certified hull that is shrunk the least. What stands above the foot gets a foot too: then, rounded or not, the
/// hull contains what lies between its points and their feet.
std::optional<ConvexPolyhedron> fit(MeshShell const& shell, std::vector<Point3d> points, double foot)
{
  for (std::size_t i = 0, n = points.size(); i < n; ++i)
    if (points[i].z > foot) points.push_back({points[i].x, points[i].y, foot});
  auto smallest = certified_hull(shell, points, foot, 1e-2);  // most hulls fail for good, and hulls are dear
  if (!smallest) return {};
  for (double const by : {0.0, 1e-7, 1e-4, 1e-3})
    if (auto body = certified_hull(shell, points, foot, by)) return body;
  return smallest;
}

}  // namespace

std::optional<ConvexPolyhedron> with_roof(MeshShell const& shell, ConvexPrism const& prism,
                                          std::span<ConvexPrism const> others, std::size_t most_corners)
{
  double const size = plan::perimeter(prism.footprint);
  double const high = prism.top + 1e-3 * (prism.top - prism.bottom);  // worth the while
  std::vector<Point3d> points;
  append_corners(prism, points);
  std::size_t const corners = points.size();
  for (auto const& v : shell.vertices)
    if (v.z > high && plan::contains(prism.footprint, {horizontal(v)}, 1e-3 * size)) points.push_back(v);
  if (corners < points.size() && points.size() <= corners + most_corners)
    if (auto body = fit(shell, points, prism.bottom)) return body;

  // Something stands on the roof that no hull can take in: up to the highest section, then.
  ConvexPrism const* highest = nullptr;
  for (auto const& k : others)
    if (k.top > high && (highest == nullptr || k.top > highest->top) &&
        plan::contains(prism.footprint, k.footprint, 1e-3 * size))
      highest = &k;
  if (highest == nullptr) return {};
  points.resize(corners);
  append_corners(*highest, points);
  return fit(shell, points, prism.bottom);
}

}  // namespace visibility::detail
