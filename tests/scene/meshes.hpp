#pragma once

#include "support/random.hpp"

#include "visibility/scene/footprint.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

/// Closed meshes that are not convex, and what goes wrong with them in files.
namespace visibility::test {

using Triangles = std::vector<Triangle>;
using Ring = std::vector<Point2d>;

inline Point3d lifted(Point2d const& p, double z) { return {p.x, p.y, z}; }

/// Plans of houses, counterclockwise, with reflex corners.
inline Ring plan_of(int kind)
{
  static std::vector<Ring> const plans{
    {{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}},                                                          // L
    {{0, 0}, {24, 0}, {24, 6}, {15, 6}, {15, 18}, {9, 18}, {9, 6}, {0, 6}},                                        // T
    {{0, 0}, {24, 0}, {24, 18}, {18, 18}, {18, 7}, {6, 7}, {6, 18}, {0, 18}},                                      // U
    {{0, 0}, {6, 0}, {6, 6}, {14, 6}, {14, 0}, {20, 0}, {20, 18}, {14, 18}, {14, 12}, {6, 12}, {6, 18}, {0, 18}},  // H
    {{0, 0}, {10, 4}, {20, 0}, {16, 10}, {20, 20}, {10, 16}, {0, 20}, {4, 10}}};  // star
  return plans[static_cast<std::size_t>(kind)];
}
inline constexpr int plan_kinds = 5;

/// A star-shaped ring: simple, far from convex.
inline Ring star(Random& random, int n, double lo, double hi)
{
  Ring ring;
  for (int i = 0; i < n; ++i) {
    double const angle = 2 * 3.14159265358979 * i / n, r = random.uniform(lo, hi);
    ring.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return ring;
}

/// The ring turned and moved, corners rounded.
inline Ring turned(Ring ring, double angle, double dx, double dy)
{
  for (auto& p : ring)
    p = {dx + p.x * std::cos(angle) - p.y * std::sin(angle), dy + p.x * std::sin(angle) + p.y * std::cos(angle)};
  return ring;
}

inline void add_quad(Triangles& mesh, Point3d const& a, Point3d const& b, Point3d const& c, Point3d const& d)
{
  mesh.push_back({{a, b, c}});
  mesh.push_back({{a, c, d}});
}

/// Walls first (two triangles each), then the roof, then the floor.
inline Triangles extrusion(Ring const& ring, double bottom, double top)
{
  Triangles mesh;
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    auto const &a = ring[i], &b = ring[(i + 1) % n];
    add_quad(mesh, lifted(a, bottom), lifted(b, bottom), lifted(b, top), lifted(a, top));
  }
  auto const pieces = convex_partition({{ring}, 0, 1});
  for (double const z : {top, bottom})
    for (auto const& piece : pieces)
      for (std::size_t i = 1; i + 1 < piece.footprint.size(); ++i)
        mesh.push_back(
          {{lifted(piece.footprint[0], z), lifted(piece.footprint[i], z), lifted(piece.footprint[i + 1], z)}});
  return mesh;
}

/// A house with a gabled roof along x; the walls are not quite straight if `noise` > 0.
inline Triangles gabled_house(Random& random, double noise)
{
  double const l = random.uniform(8, 20), w = random.uniform(6, 10), eaves = random.uniform(3, 8),
               ridge = eaves + random.uniform(1, 5), angle = random.uniform(0, 6);
  std::vector<Point3d> v;
  for (double const z : {0.0, eaves})
    for (auto const& p : Ring{{0, 0}, {l, 0}, {l, w}, {0, w}}) v.push_back(lifted(p, z));
  v.push_back({0, w / 2, ridge});
  v.push_back({l, w / 2, ridge});
  for (auto& p : v) {
    Point2d const q = turned({horizontal(p)}, angle, 100, 200)[0];
    p = {q.x + random.uniform(-noise, noise), q.y + random.uniform(-noise, noise),
         p.z == 0 ? 0 : p.z + random.uniform(-noise, noise)};
  }
  Triangles mesh;
  for (std::size_t i = 0; i < 4; ++i) add_quad(mesh, v[i], v[(i + 1) % 4], v[4 + (i + 1) % 4], v[4 + i]);
  mesh.push_back({{v[5], v[6], v[9]}});
  mesh.push_back({{v[7], v[4], v[8]}});
  add_quad(mesh, v[4], v[5], v[9], v[8]);
  add_quad(mesh, v[6], v[7], v[8], v[9]);
  add_quad(mesh, v[0], v[3], v[2], v[1]);
  return mesh;
}

/// A box whose roof is a grid of random heights: dents and bumps.
inline Triangles dented_box(Random& random, int n)
{
  std::vector<std::vector<Point3d>> roof;
  for (int i = 0; i <= n; ++i) {
    roof.emplace_back();
    for (int j = 0; j <= n; ++j) roof.back().push_back({4.0 * i, 4.0 * j, random.uniform(6, 12)});
  }
  Triangles mesh;
  auto const foot = [](Point3d const& p) { return Point3d{p.x, p.y, 0}; };
  std::vector<Point3d> rim;
  std::size_t const N = static_cast<std::size_t>(n);
  for (std::size_t i = 0; i < N; ++i) rim.push_back(roof[i][0]);
  for (std::size_t j = 0; j < N; ++j) rim.push_back(roof[N][j]);
  for (std::size_t i = N; i > 0; --i) rim.push_back(roof[i][N]);
  for (std::size_t j = N; j > 0; --j) rim.push_back(roof[0][j]);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    auto const &a = rim[i], &b = rim[(i + 1) % rim.size()];
    add_quad(mesh, foot(a), foot(b), b, a);
    mesh.push_back({{foot(a), foot(b), {2.0 * n, 2.0 * n, 0}}});
  }
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j) add_quad(mesh, roof[i][j], roof[i + 1][j], roof[i + 1][j + 1], roof[i][j + 1]);
  return mesh;
}

/// An extrusion whose roof is turned against its floor: walls are bent and may cross each other.
inline Triangles twisted(Ring const& ring, double angle)
{
  Triangles mesh = extrusion(ring, 0, 10);
  for (auto& t : mesh)
    for (auto& p : t.vertices)
      if (p.z == 10) {
        Point2d const q = turned({{p.x - 10, p.y - 8}}, angle, 10, 8)[0];
        p = {q.x, q.y, 10};
      }
  return mesh;
}

inline void append(Triangles& mesh, Triangles const& more) { mesh.insert(mesh.end(), more.begin(), more.end()); }

/// Same set of triangles: any order, any orientation, any first corner.
inline void shuffle(Triangles& mesh, Random& random)
{
  for (std::size_t i = mesh.size(); i > 1; --i)
    std::swap(mesh[i - 1], mesh[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  for (auto& t : mesh) {
    std::rotate(t.vertices.begin(), t.vertices.begin() + random.below(3), t.vertices.end());
    if (random.chance(0.5)) std::swap(t.vertices[0], t.vertices[1]);
  }
}

/// A scene of one object; every triangle has vertices of its own.
inline Scene scene_of(Triangles const& mesh)
{
  SceneBuilder builder("test");
  builder.begin_object("mesh");
  for (auto const& t : mesh) {
    auto const a = builder.add_vertex(t.vertices[0]);
    auto const b = builder.add_vertex(t.vertices[1]);
    builder.add_triangle(a, b, builder.add_vertex(t.vertices[2]));
  }
  return builder.finish();
}

}  // namespace visibility::test
