#pragma once

#include "support/catch.hpp"

#include "visibility/scene/convex_bodies.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace visibility::test {

/// FNV-1a of every name, coordinate and index of a scene, byte by byte in an order that no machine changes.
inline std::uint64_t fingerprint(Scene const& scene)
{
  std::uint64_t h = 0xCBF29CE484222325;
  auto const byte = [&h](std::uint64_t b) { h = (h ^ (b & 0xFF)) * 0x100000001B3; };
  auto const integer = [&byte](std::uint64_t v) {
    for (int shift = 0; shift < 64; shift += 8) byte(v >> shift);
  };
  auto const point = [&integer](Point3d const& p) {
    for (double const c : {p.x, p.y, p.z}) integer(std::bit_cast<std::uint64_t>(c));
  };
  for (auto const& o : scene.objects) {
    for (char const c : o.name) byte(static_cast<unsigned char>(c));
    for (auto const& r : {o.boxes, o.balls, o.prisms, o.polyhedra, o.triangles}) integer(r.last);
  }
  for (auto const& b : scene.boxes) point(b.min), point(b.max);
  for (auto const& b : scene.balls) point(b.centre), integer(std::bit_cast<std::uint64_t>(b.radius));
  for (auto const& v : scene.vertices) point(v);
  for (auto const& t : scene.triangles)
    for (auto const i : t) integer(i);
  return h;
}

/// Whether the triangles of the object are closed surfaces: every edge lies in two of them, once each way.
inline bool is_closed(Scene const& scene, Object const& object)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (auto i = object.triangles.first; i < object.triangles.last; ++i)
    for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(scene.triangles[i][k], scene.triangles[i][(k + 1) % 3]);
  std::ranges::sort(edges);
  if (std::ranges::adjacent_find(edges) != edges.end()) return false;
  return std::ranges::all_of(
    edges, [&](auto const& e) { return std::ranges::binary_search(edges, std::pair(e.second, e.first)); });
}

/// Rounded volume within the closed surfaces of the object: positive iff they face outward.
inline double volume(Scene const& scene, Object const& object)
{
  double sum = 0;
  Point3d const o = scene.vertices[scene.triangles[object.triangles.first][0]];
  for (auto i = object.triangles.first; i < object.triangles.last; ++i) {
    auto const& [a, b, c] = scene.triangle(i).vertices;
    Point3d const u{a.x - o.x, a.y - o.y, a.z - o.z}, v{b.x - o.x, b.y - o.y, b.z - o.z},
      w{c.x - o.x, c.y - o.y, c.z - o.z};
    sum += u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x);
  }
  return sum / 6;
}

/// How many convex solids the library finds in the scene; REQUIREs that it finds nothing else.
inline std::size_t convex_solids(Scene const& scene)
{
  ConvexBodies const bodies(scene);
  for (auto const& b : bodies.bodies()) REQUIRE(b.kind == ConvexBodies::Kind::polyhedron);
  return bodies.bodies().size();
}

/// Whether the bounding boxes of all objects are disjoint seen from above.
inline bool are_apart(Scene const& scene)
{
  std::vector<Box> boxes;
  for (auto const& o : scene.objects) {
    boxes.push_back(bounding_box(scene, o));
    boxes.back().min.z = boxes.back().max.z = 0;
  }
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (meet(boxes[i], boxes[k])) return false;
  return true;
}

}  // namespace visibility::test
