#include "inner_body_checks.hpp"
#include "support/real_scenes.hpp"
#include "support/trials.hpp"

#include "visibility/scene/read_scene.hpp"

#include <numeric>

using namespace visibility;
using namespace visibility::test;

namespace {

struct City {
  char const* file;
  double least_share;  ///< of the buildings with an interior that have inner bodies
};
// Delfshaven's walls have gaps: most of it must stay without.
constexpr City cities[] = {{"city/etoile.ply", 0.98},
                           {"city/munich.ply", 0.98},
                           {"city/rotterdam_centre.ply", 0.98},
                           {"city/lower_manhattan.ply", 0.95},
                           {"cityjson/val3dity_3-20-DELFSHAVEN.city.json", 0.1}};

}  // namespace

TEST_CASE("inner bodies: real buildings have them, and block what they block", "[scene][conservative]")
{
  for (auto const& city : cities) {
    auto const path = real_scene(city.file);
    if (!path) continue;
    CAPTURE(city.file);
    ReadOptions options;
    if (path->extension() == ".ply") options.object_property = "building";
    Scene const scene = read_scene(*path, options);
    Random random(84);
    Reached reached;
    int buildings = 0, with_bodies = 0;
    for (int i = 0; i < trials(60); ++i) {
      Object const& object = scene.objects[static_cast<std::size_t>(random.below(int(scene.objects.size())))];
      if (object.triangles.size() > 400 || !bounding_box(scene, object).has_interior()) continue;
      CAPTURE(object.name);
      std::vector<std::uint32_t> all(object.triangles.size());
      std::iota(all.begin(), all.end(), object.triangles.first);
      auto const bodies = inner_bodies(scene, object, all);
      ++buildings;
      with_bodies += !bodies.empty();
      Triangles mesh;
      for (auto const t : all) mesh.push_back(scene.triangle(t));
      check_promise(mesh, bodies, random, 8, reached);
    }
    CHECK(buildings > trials(20));
    CHECK(with_bodies >= city.least_share * buildings);
    CHECK(reached.blocked > reached.lines / 10);
  }
}
