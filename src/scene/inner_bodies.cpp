#include "visibility/scene/inner_bodies.hpp"

#include "inner_prisms.hpp"
#include "inner_roofs.hpp"
#include "inner_stacks.hpp"
#include "plan.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace visibility {

namespace {

using namespace detail;

/// Coordinates up to this magnitude, so that no rounded area or volume overflows.
constexpr double domain = 0x1p300;

bool is_in_domain(Box const& b)
{
  return std::max({std::abs(b.min.x), std::abs(b.min.y), std::abs(b.min.z), std::abs(b.max.x), std::abs(b.max.y),
                   std::abs(b.max.z)}) <= domain;
}

/// Mean area of the body's silhouette over all horizontal directions [Cauchy].
double side_view(ConvexPrism const& k) { return (k.top - k.bottom) * plan::perimeter(k.footprint) / std::numbers::pi; }
double side_view(ConvexPolyhedron const& k)
{
  double sum = 0;
  for (auto const& f : k.facets) {
    Point3d const &a = k.vertices[f.vertices[0]], &b = k.vertices[f.vertices[1]], &c = k.vertices[f.vertices[2]];
    sum += std::hypot((b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y),
                      (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z)) /
           2;
  }
  return sum / std::numbers::pi;
}
double side_view(InnerBody const& k)
{
  return std::visit([](auto const& shape) { return side_view(shape); }, k.shape);
}

std::vector<Point3d> corners(InnerBody const& k)
{
  if (auto const* body = std::get_if<ConvexPolyhedron>(&k.shape)) return body->vertices;
  std::vector<Point3d> out;
  auto const& prism = std::get<ConvexPrism>(k.shape);
  for (auto const& p : prism.footprint)
    for (double const z : {prism.bottom, prism.top}) out.push_back({p.x, p.y, z});
  return out;
}

/// Rounded; the body is allowed to be `slack` too small.
bool contains(ConvexPrism const& k, std::vector<Point3d> const& points, double slack)
{
  return std::ranges::all_of(points, [&](Point3d const& p) {
    return p.z >= k.bottom - slack && p.z <= k.top + slack && plan::contains(k.footprint, {horizontal(p)}, slack);
  });
}
bool contains(ConvexPolyhedron const& k, std::vector<Point3d> const& points, double slack)
{
  return std::ranges::all_of(k.facets, [&](ConvexPolyhedron::Facet const& f) {
    Point3d const &a = k.vertices[f.vertices[0]], &b = k.vertices[f.vertices[1]], &c = k.vertices[f.vertices[2]];
    Point3d const n{(b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y),
                    (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z),
                    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)};
    double const room = slack * std::hypot(n.x, n.y, n.z);
    return std::ranges::all_of(
      points, [&](Point3d const& p) { return n.x * (p.x - a.x) + n.y * (p.y - a.y) + n.z * (p.z - a.z) <= room; });
  });
}

/// The bodies of the largest side view, without those that a larger one as good as contains.
std::vector<InnerBody> chosen(std::vector<InnerBody> bodies, std::size_t most)
{
  std::ranges::stable_sort(bodies, std::greater<>{}, [](InnerBody const& k) { return side_view(k); });
  std::vector<InnerBody> out;
  for (auto& k : bodies) {
    if (out.size() == most) break;
    auto const points = corners(k);
    double const slack = 1e-3 * std::sqrt(side_view(k));
    bool const idle = std::ranges::any_of(out, [&](InnerBody const& larger) {
      return larger.floor <= k.floor && larger.needs_outside <= k.needs_outside &&
             std::visit([&](auto const& shape) { return contains(shape, points, slack); }, larger.shape);
    });
    if (!idle) out.push_back(std::move(k));
  }
  return out;
}

}  // namespace

std::vector<InnerBody> inner_bodies(Scene const& scene, Object const& object,
                                    std::span<std::uint32_t const> loose_triangles, InnerBodyOptions const& options)
{
  std::vector<InnerBody> bodies;
  for (auto i = object.prisms.first; i < object.prisms.last; ++i)
    if (is_in_domain(bounding_box(scene.prisms[i])))
      for (auto& k : convex_cover(scene.prisms[i]))
        bodies.push_back({std::move(k), -std::numeric_limits<double>::infinity(), false});
  for (auto const& shell : mesh_shells(scene, loose_triangles, options.max_triangles)) {
    if (!is_in_domain(shell.bounds)) continue;
    auto prisms = inner_prisms(shell, options);
    std::ranges::stable_sort(prisms, std::greater<>{}, [](ConvexPrism const& k) { return side_view(k); });
    std::vector<ConvexPolyhedron> hulls;
    for (std::size_t i = 0; i < prisms.size(); ++i) {
      InnerBody const& body = bodies.emplace_back(InnerBody{prisms[i], shell.floor, true});
      if (!options.roofs || i >= options.max_bodies) continue;
      auto const points = corners(body);
      double const slack = 1e-3 * std::sqrt(side_view(body));
      if (std::ranges::any_of(hulls, [&](auto const& k) { return contains(k, points, slack); })) continue;
      if (auto hull = with_roof(shell, prisms[i], prisms, options.max_corners)) hulls.push_back(std::move(*hull));
    }
    for (auto& k : hulls) bodies.push_back({std::move(k), shell.floor, true});
  }
  auto towers = stacks(bodies);
  bodies.insert(bodies.end(), std::make_move_iterator(towers.begin()), std::make_move_iterator(towers.end()));
  return chosen(std::move(bodies), options.max_bodies);
}

Box bounding_box(InnerBody const& body)
{
  return std::visit([](auto const& shape) { return bounding_box(shape); }, body.shape);
}

}  // namespace visibility
