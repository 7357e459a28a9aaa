#include "visibility/scene/enclosing_shells.hpp"

#include "meshes.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <map>

using namespace visibility;
using namespace visibility::test;

namespace {

/// How often each side is used, by the positions of its ends.
using Key = std::array<double, 6>;
std::map<Key, int> sides(EnclosingShell const& shell)
{
  std::map<Key, int> out;
  for (std::size_t f = 0; f < shell.facets(); ++f) {
    auto const around = shell.facet(f);
    for (std::size_t k = 0; k < around.size(); ++k) {
      auto const &p = shell.vertices[around[k]], &q = shell.vertices[around[(k + 1) % around.size()]];
      Key const a{p.x, p.y, p.z, q.x, q.y, q.z}, b{q.x, q.y, q.z, p.x, p.y, p.z};
      ++out[std::min(a, b)];
    }
  }
  return out;
}

void require_even_above(EnclosingShell const& shell)
{
  for (auto const& [key, count] : sides(shell))
    if (std::max(key[2], key[5]) > shell.floor) REQUIRE(count % 2 == 0);
}

}  // namespace

TEST_CASE("enclosing shells: sides are even above the floor", "[scene][law]")
{
  double const none = -std::numeric_limits<double>::infinity();
  for (int kind = 0; kind < plan_kinds; ++kind) {
    CAPTURE(kind);
    auto mesh = extrusion(plan_of(kind), 0, 10);
    auto const floor_of = [](Triangles const& triangles) {
      Scene const scene = scene_of(triangles);
      ConvexBodies const bodies(scene);
      EnclosingShells const shells(bodies, 1000);
      if (shells.size() == 0) return HUGE_VAL;
      REQUIRE(shells.of_object(0).size() == 1);
      require_even_above(shells.of_object(0)[0]);
      return shells.of_object(0)[0].floor;
    };
    CHECK(floor_of(mesh) == none);
    // A wall divided by a point that the next walls and the roof do not have.
    auto divided = mesh;
    auto const [a, b, c] = divided[0].vertices;
    Point3d const middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    divided[0] = {{a, middle, c}};
    divided.push_back({{middle, b, c}});
    CHECK(floor_of(divided) == none);
    std::erase_if(mesh, [](Triangle const& t) { return bounding_box(t).max.z == 0; });
    CHECK(floor_of(mesh) == 0);
    mesh.erase(mesh.begin());
    CHECK(floor_of(mesh) == HUGE_VAL);  // a wall is missing up to the top
  }
}

TEST_CASE("enclosing shells: none of convex solids, and of what hides nothing", "[scene]")
{
  Point3d const p{0, 0, 0}, q{4, 0, 0}, r{0, 4, 0}, t{0, 0, 4};
  Triangles const solid{{{p, r, q}}, {{p, q, t}}, {{q, r, t}}, {{r, p, t}}}, house = extrusion(plan_of(0), 0, 10);
  for (bool const hides : {true, false}) {
    SceneBuilder builder("test");
    for (auto const* mesh : {&solid, &house}) {
      if (hides)
        builder.begin_object("mesh");
      else
        builder.begin_occludee("mesh");
      std::map<std::array<double, 3>, std::uint32_t> index;
      auto const vertex = [&](Point3d const& at) {
        auto const [i, is_new] = index.try_emplace({at.x, at.y, at.z});
        if (is_new) i->second = builder.add_vertex(at);
        return i->second;
      };
      for (auto const& f : *mesh)
        builder.add_triangle(vertex(f.vertices[0]), vertex(f.vertices[1]), vertex(f.vertices[2]));
    }
    Scene const scene = builder.finish();
    ConvexBodies const bodies(scene);
    EnclosingShells const shells(bodies, 1000);
    CHECK(shells.size() == (hides ? 1 : 0));
    CHECK(shells.of_object(0).empty());
    CHECK(shells.of_object(1).size() == (hides ? 1 : 0));
    CHECK(EnclosingShells(bodies, 3).size() == 0);
  }
}
