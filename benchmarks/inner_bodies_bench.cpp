// Inner bodies of a scene: how many objects have some, how much of the object the largest one covers, what it costs.
//
//   inner_bodies_bench [SCENE = gen:district] [PLY object property]
//
// Reads a scene file, or generates one, and looks for inner bodies of every object that is more than one convex body:
// of all its triangles, and of its prisms. The shares compare the largest inner body with the convex hull of the
// object: by volume, and by "side view", the mean area of the silhouette over horizontal directions. One JSON object.

#include "visibility/scene/generators.hpp"
#include "visibility/scene/inner_bodies.hpp"
#include "visibility/scene/read_scene.hpp"

#include "visibility/scene/convex_bodies.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <numeric>

using namespace visibility;

namespace {

struct Size {
  double volume = 0;
  double side_view = 0;  ///< mean area of the silhouette over horizontal directions
};

Size size_of(ConvexPolyhedron const& k)
{
  Size s;
  Point3d const& o = k.vertices.front();
  for (auto const& f : k.facets) {
    auto const v = [&](int i) {
      Point3d const& p = k.vertices[f.vertices[static_cast<std::size_t>(i)]];
      return Point3d{p.x - o.x, p.y - o.y, p.z - o.z};
    };
    Point3d const a = v(0), b = v(1), c = v(2), u{b.x - a.x, b.y - a.y, b.z - a.z}, w{c.x - a.x, c.y - a.y, c.z - a.z};
    Point3d const n{u.y * w.z - u.z * w.y, u.z * w.x - u.x * w.z, u.x * w.y - u.y * w.x};
    s.volume += (n.x * a.x + n.y * a.y + n.z * a.z) / 6;
    s.side_view += std::hypot(n.x, n.y) / 2 / std::numbers::pi;
  }
  return s;
}

std::vector<Point3d> corners(InnerBody const& body)
{
  if (auto const* k = std::get_if<ConvexPolyhedron>(&body.shape)) return k->vertices;
  std::vector<Point3d> out;
  auto const& prism = std::get<ConvexPrism>(body.shape);
  for (auto const& p : prism.footprint)
    for (double const z : {prism.bottom, prism.top}) out.push_back({p.x, p.y, z});
  return out;
}

double median(std::vector<double> x)
{
  if (x.empty()) return 0;
  std::ranges::nth_element(x, x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2));
  return x[x.size() / 2];
}

double mean(std::vector<double> const& x)
{
  return x.empty() ? 0 : std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

Scene load(std::string const& argument, std::string const& object_property)
{
  if (argument.starts_with("gen:")) return generate(argument.substr(4));
  ReadOptions options;
  options.object_property = object_property;
  return read_scene(argument, options);
}

}  // namespace

int main(int argc, char** argv)
{
  Scene const scene = load(argc > 1 ? argv[1] : "gen:district", argc > 2 ? argv[2] : "");
  ConvexBodies const bodies(scene);
  std::size_t candidates = 0, with_bodies = 0, total = 0, polyhedra = 0, raised = 0, triangles = 0;
  double seconds = 0, slowest = 0;
  std::vector<double> volume, side_view;
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    if (bodies.bodies_of(id).size() < 2) continue;  // convex as it is
    std::vector<Point3d> points;
    for (auto const& b : bodies.bodies_of(id)) bodies.append_vertices(b, points);
    auto const range = scene.objects[id].triangles;
    std::vector<std::uint32_t> all(range.size());
    std::iota(all.begin(), all.end(), range.first);
    ++candidates;
    triangles += all.size();
    auto const start = std::chrono::steady_clock::now();
    auto const inner = inner_bodies(scene, scene.objects[id], all);
    double const took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    seconds += took;
    slowest = std::max(slowest, took);
    if (inner.empty()) continue;
    ++with_bodies;
    total += inner.size();
    double const foot = visibility::bounding_box(scene, scene.objects[id]).min.z;
    for (auto const& k : inner) {
      polyhedra += std::holds_alternative<ConvexPolyhedron>(k.shape);
      raised += k.floor > foot;
    }
    Size const hull = size_of(ConvexPolyhedron::hull(points));
    Size const largest = size_of(ConvexPolyhedron::hull(corners(inner.front())));
    volume.push_back(largest.volume / hull.volume);
    side_view.push_back(largest.side_view / hull.side_view);
    if (!(volume.back() <= 1.001)) {
      std::fprintf(stderr, "object %s: a body larger than the hull\n", scene.objects[id].name.c_str());
      return EXIT_FAILURE;
    }
  }
  std::printf("{\"scene\": \"%s\", \"objects\": %zu, \"not_convex\": %zu, \"triangles\": %zu, \"with_bodies\": %zu, "
              "\"bodies\": %zu, \"hulls\": %zu, \"floor_above_foot\": %zu, \"bodies_per_object\": %.2f, "
              "\"volume_of_hull_mean\": %.3f, \"volume_of_hull_median\": %.3f, \"side_view_of_hull_mean\": %.3f, "
              "\"side_view_of_hull_median\": %.3f, \"seconds\": %.3f, \"ms_per_object\": %.4f, \"slowest_ms\": %.1f}\n",
              scene.source.c_str(), scene.objects.size(), candidates, triangles, with_bodies, total, polyhedra, raised,
              double(total) / double(std::max<std::size_t>(with_bodies, 1)), mean(volume), median(volume),
              mean(side_view), median(side_view), seconds,
              1000 * seconds / double(std::max<std::size_t>(candidates, 1)), 1000 * slowest);
}
