#include "scene/meshes.hpp"
#include "support/catch.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"

#include <algorithm>

using namespace visibility;
using namespace visibility::test;
using Set = std::vector<std::uint32_t>;

namespace {

Triangles moved(Triangles mesh, double dx, double dy)
{
  for (auto& t : mesh)
    for (auto& p : t.vertices) p = {p.x + dx, p.y + dy, p.z};
  return mesh;
}

/// A town of 48 meshes that are not convex, with a free place in the middle: plans with reflex corners, dented roofs,
/// twisted walls, some with a wall missing, some open at the bottom.
Scene town(Random& random)
{
  SceneBuilder builder("town");
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) {
      if (i == 0 && j == 0) continue;
      Ring const plan = plan_of(random.below(plan_kinds));
      Triangles mesh = random.chance(0.2)   ? dented_box(random, 4)
                       : random.chance(0.2) ? twisted(plan, 0.05)
                                            : extrusion(plan, 0, random.uniform(10, 40));
      if (random.chance(0.1)) mesh.erase(mesh.begin(), mesh.begin() + 2);
      if (random.chance(0.2))
        std::erase_if(
          mesh, [](Triangle const& t) { return std::ranges::all_of(t.vertices, [](auto& p) { return p.z == 0; }); });
      builder.begin_object("house");
      for (auto const& t : moved(mesh, 30.0 * i - 10, 30.0 * j - 10)) {
        auto const a = builder.add_vertex(t.vertices[0]);
        builder.add_vertex(t.vertices[1]);
        builder.add_triangle(a, a + 1, builder.add_vertex(t.vertices[2]));
      }
    }
  return builder.finish();
}

ViewCell cell_at(double z) { return ViewCell(Box{{-3, -2, z}, {2, 3, z + 2}}); }

/// Members of the scene that a random sight line sees, decided on the triangles alone.
Set seen(Scene const& scene, ViewCell const& cell, Random& random, int lines)
{
  PreparedScene const prepared(scene);
  Set out;
  for (int i = 0; i < lines; ++i) {
    auto const t = static_cast<std::size_t>(random.below(static_cast<int>(scene.triangles.size())));
    auto const& v = scene.triangle(t).vertices;
    double const a = random.uniform(0.1, 0.5), b = random.uniform(0.1, 0.4);
    auto const mix = [&](double x, double y, double z) { return x + a * (y - x) + b * (z - x); };
    Point3d const s{mix(v[0].x, v[1].x, v[2].x), mix(v[0].y, v[1].y, v[2].y), mix(v[0].z, v[1].z, v[2].z)};
    Box const& c = cell.bounds();
    Point3d const p{random.uniform(c.min.x, c.max.x), random.uniform(c.min.y, c.max.y),
                    random.uniform(c.min.z, c.max.z)};
    // s is on its triangle up to rounding; the line is cut short of it.
    Point3d const q{p.x + 0.999 * (s.x - p.x), p.y + 0.999 * (s.y - p.y), p.z + 0.999 * (s.z - p.z)};
    SegmentProbe const probe(p, q);
    bool const blocked = prepared.body_hierarchy().any_along(probe, [&](std::uint32_t body) {
      return segment_meets<Filtered>(prepared.bodies(), prepared.bodies().bodies()[body], p, q);
    });
    if (blocked) continue;
    auto const owner = std::ranges::find_if(scene.objects, [&](Object const& o) { return t < o.triangles.last; });
    out.push_back(static_cast<std::uint32_t>(owner - scene.objects.begin()));
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

TEST_CASE("inner occluders: they hide more, and nothing that a sight line sees", "[methods][conservative]")
{
  for (int seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    Scene const scene = town(random);
    PreparedScene const plain(scene), with(scene, InnerBodyOptions{});
    REQUIRE(with.occluders().inner_count() > 20);
    REQUIRE(plain.occluders().inner_count() == 0);
    // On the ground, and half below it, where open bottoms do not hide.
    for (double const z : {0.5, -1.0}) {
      auto const cell = cell_at(z);
      auto const loose = StrongOcclusion<>()(plain, cell).visible, tight = StrongOcclusion<>()(with, cell).visible;
      REQUIRE(std::ranges::includes(loose, tight));
      REQUIRE(std::ranges::includes(tight, seen(scene, cell, random, 4000)));
      if (z > 0) REQUIRE(tight.size() + 5 < loose.size());
    }
  }
}

TEST_CASE("inner occluders: they are used only from cells for which they are certified", "[methods][degenerate]")
{
  // An L without floor around nothing: from below the ground one looks into it, and through its open bottom.
  SceneBuilder builder("test");
  builder.begin_object("open");
  Triangles walls = extrusion(plan_of(0), 0, 30);
  std::erase_if(walls,
                [](Triangle const& t) { return std::ranges::all_of(t.vertices, [](auto& p) { return p.z == 0; }); });
  for (auto const& t : walls) {
    auto const a = builder.add_vertex(t.vertices[0]);
    builder.add_vertex(t.vertices[1]);
    builder.add_triangle(a, a + 1, builder.add_vertex(t.vertices[2]));
  }
  builder.begin_object("inside");
  builder.add(Box{{3, 3, 10}, {4, 4, 11}});
  Scene const scene = builder.finish();
  PreparedScene const prepared(scene, InnerBodyOptions{});
  REQUIRE(prepared.occluders().inner_count() > 0);
  auto const sees_inside = [&](Box const& cell) {
    auto const set = StrongOcclusion<>()(prepared, ViewCell(cell)).visible;
    return std::ranges::binary_search(set, 1U);
  };
  REQUIRE_FALSE(sees_inside({{-9, 2, 1}, {-8, 4, 2}}));
  REQUIRE(sees_inside({{3, 3, -6}, {4, 4, -5}}));  // from below
  REQUIRE(sees_inside({{2, 2, 2}, {3, 3, 3}}));    // from within
}

TEST_CASE("inner occluders: optimizations and refinement change nothing with them either", "[methods][law]")
{
  using O = StrongOcclusion<>::Options;
  for (int seed = 11; seed <= 13; ++seed) {
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    Scene const scene = town(random);
    PreparedScene const prepared(scene, InnerBodyOptions{});
    auto const cell = cell_at(0.5);
    for (auto const g : {strong_occlusion::Granularity::object, strong_occlusion::Granularity::face}) {
      auto const expected = StrongOcclusion<>(O::naive(g))(prepared, cell).visible;
      REQUIRE(StrongOcclusion<>({.granularity = g})(prepared, cell).visible == expected);
      for (auto const& [name, flag] : strong_occlusion::optimizations) {
        O options{.granularity = g};
        options.*flag = false;
        REQUIRE(StrongOcclusion<>(options)(prepared, cell).visible == expected);
      }
    }
    StrongOcclusion<> const method;
    ViewCell const part(Box{{-3, -2, 0.5}, {0, 1, 2.5}});
    auto const rest = method.refine(StrongOcclusion<>::Remainder(prepared), cell).second;
    REQUIRE(method(rest, part).visible == method(prepared, part).visible);
    REQUIRE(StrongOcclusion<Rational>()(prepared, part).visible == method(prepared, part).visible);
  }
}
