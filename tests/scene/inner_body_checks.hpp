#pragma once

#include "meshes.hpp"
#include "support/catch.hpp"

#include "visibility/geometry/segment_polyhedron.hpp"
#include "visibility/geometry/segment_prism.hpp"
#include "visibility/geometry/segment_triangle.hpp"
#include "visibility/scene/inner_bodies.hpp"

/// What an inner body promises, put to the test by sight lines.
namespace visibility::test {

inline Box bounds_of(Triangles const& mesh)
{
  Box b;
  for (auto const& t : mesh) b.extend(bounding_box(t));
  return b;
}

inline std::vector<Point3d> corners(InnerBody const& k)
{
  if (auto const* body = std::get_if<ConvexPolyhedron>(&k.shape)) return body->vertices;
  std::vector<Point3d> out;
  auto const& prism = std::get<ConvexPrism>(k.shape);
  for (auto const& p : prism.footprint)
    for (double const z : {prism.bottom, prism.top}) out.push_back(lifted(p, z));
  return out;
}

inline bool blocks(InnerBody const& k, Point3d const& p, Point3d const& s)
{
  return std::visit([&](auto const& shape) { return segment_meets<Rational, End::excluded>(shape, p, s); }, k.shape);
}

inline bool blocks(Triangles const& mesh, Point3d const& p, Point3d const& s)
{
  return std::ranges::any_of(mesh, [&](Triangle const& t) { return segment_meets<Rational, End::excluded>(t, p, s); });
}

/// a + t (b - a), rounded.
inline Point3d between(Point3d const& a, Point3d const& b, double t)
{
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/// The end of a sight line from p that just meets, just misses, touches or ends on the body.
inline Point3d target(std::vector<Point3d> const& v, Point3d const& p, Box const& around, Random& random)
{
  auto const any = [&] { return v[static_cast<std::size_t>(random.below(static_cast<int>(v.size())))]; };
  auto const anywhere = [&] {
    return Point3d{random.uniform(around.min.x, around.max.x), random.uniform(around.min.y, around.max.y),
                   random.uniform(around.min.z, around.max.z)};
  };
  switch (random.below(7)) {
  case 0: return any();                                 // ends in a corner
  case 1: return between(p, any(), 2);                  // through a corner
  case 2: return between(any(), any(), random.unit());  // ends on an edge or inside
  case 3: return between(p, between(any(), any(), random.unit()), random.uniform(1, 3));
  case 4: return between(p, between(any(), any(), random.unit()), 1 + 0x1p-40);  // just through an edge
  case 5: return between(any(), anywhere(), 1e-9);
  default: return anywhere();
  }
}

struct Reached {
  int meshes = 0, bodies = 0, hulls = 0, lines = 0, blocked = 0;
};

/// The promise of an inner body, on random half-open sight lines from outside the mesh's box and above the floor.
inline void check_promise(Triangles const& mesh, std::vector<InnerBody> const& bodies, Random& random, int lines,
                          Reached& reached)
{
  Box const bounds = bounds_of(mesh);
  double const dx = bounds.max.x - bounds.min.x, dy = bounds.max.y - bounds.min.y, dz = bounds.max.z - bounds.min.z;
  Box const around{{bounds.min.x - dx, bounds.min.y - dy, bounds.min.z - dz},
                   {bounds.max.x + dx, bounds.max.y + dy, bounds.max.z + dz}};
  ++reached.meshes;
  for (auto const& k : bodies) {
    ++reached.bodies;
    reached.hulls += std::holds_alternative<ConvexPolyhedron>(k.shape);
    std::visit([](auto const& shape) { shape.validate(); }, k.shape);
    REQUIRE(k.needs_outside);
    auto const v = corners(k);
    for (auto const& p : v) REQUIRE(contains(bounds, p));
    for (int i = 0; i < lines; ++i) {
      Point3d p{random.uniform(around.min.x, around.max.x), random.uniform(around.min.y, around.max.y),
                random.uniform(around.min.z, around.max.z)};
      if (random.chance(0.2)) {  // along an edge or a diagonal of the body
        auto const any = [&] { return v[static_cast<std::size_t>(random.below(static_cast<int>(v.size())))]; };
        p = between(any(), any(), 8);
      }
      if (random.chance(0.3)) p.z = v[static_cast<std::size_t>(random.below(static_cast<int>(v.size())))].z;
      if (contains(bounds, p) || !(p.z > k.floor)) continue;
      Point3d const s = target(v, p, around, random);
      if (p == s) continue;
      ++reached.lines;
      if (!blocks(k, p, s)) continue;
      ++reached.blocked;
      CAPTURE(p.x, p.y, p.z, s.x, s.y, s.z, k.floor);
      REQUIRE(blocks(mesh, p, s));
    }
  }
}

}  // namespace visibility::test
