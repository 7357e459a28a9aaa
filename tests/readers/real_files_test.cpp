#include "support/catch.hpp"
#include "support/real_scenes.hpp"

#include "visibility/scene/read_scene.hpp"

using namespace visibility;

namespace {

/// Counted by other means: a few lines of Python over the raw files; a simple polygon of n points with h holes is
/// n + 2h - 2 triangles.
struct Expected {
  char const* file;
  std::size_t objects, triangles, prisms, dropped_polygons;
};
constexpr Expected expected[] = {
  {"city/etoile.ply", 280, 13056, 0, 0},
  {"city/munich.ply", 1188, 38936, 0, 0},
  {"city/lower_manhattan.ply", 2438, 235531, 0, 0},
  {"city/rotterdam_centre.ply", 9016, 308277, 0, 0},
  {"city/tokyo_akihabara.geojsonl", 629, 0, 629, 0},
  {"city/tokyo_chuo.geojsonl.gz", 15860, 0, 15860, 0},
  {"city/tokyo_central6.geojsonl.gz", 182327, 0, 182327, 0},
  {"city/lyon1.geojson", 2576, 0, 2576, 0},
  {"interior/hospital_floor_01.obj", 10, 5103, 0, 0},
  {"cityjson/3dfier_testarea.json", 160, 6854, 0, 0},
  {"cityjson/cjio_DH_01_subs.city.json", 9, 148, 0, 0},
  {"cityjson/cjio_delft.json", 160, 5563, 0, 0},
  {"cityjson/cjio_rotterdam_subset.json", 16, 622, 0, 12},
  {"cityjson/cjio_zurich_subset_lod2.json", 161, 5142, 0, 0},
  {"cityjson/kriger_citjsnClean_uEstate10m.json", 305, 6680, 0, 0},
  {"cityjson/loader_3db_sub.json", 26, 768, 0, 0},
  {"cityjson/rhino_Rotterdam.json", 91, 1660, 0, 0},
  // 37,536 triangles if all polygons were simple: six of 16 triangles together are not
  {"cityjson/val3dity_3-20-DELFSHAVEN.city.json", 853, 37520, 0, 633 + 6},
};

std::size_t dropped(Scene const& scene)
{
  std::size_t n = 0;
  for (auto const& note : scene.notes)
    if (note.find(" polygons ") != std::string::npos) n += std::stoul(note);
  return n;
}

}  // namespace

TEST_CASE("real files: objects, triangles and footprints", "[readers]")
{
  for (auto const& e : expected) {
    auto const path = test::real_scene(e.file);
    if (!path) continue;
    CAPTURE(e.file);
    Scene const s = read_scene(*path);
    REQUIRE_NOTHROW(s.validate());
    CHECK(s.objects.size() == e.objects);
    CHECK(s.triangles.size() == e.triangles);
    CHECK(s.prisms.size() == e.prisms);
    CHECK(dropped(s) == e.dropped_polygons);
  }
}

TEST_CASE("real files: Lyon stands on its hill", "[readers]")
{
  auto const path = test::real_scene("city/lyon1.geojson");
  if (!path) return;
  Scene const s = read_scene(*path);
  CHECK(s.objects[0].name == "BATIMENT0000000240876972");
  CHECK(s.prisms[0].bottom == 200.6);
  CHECK(s.prisms[0].top == 200.6 + 9.2);
  CHECK(s.prisms[0].rings[0][0] == Point2d{1841205.541376449167728, 5176065.184761937707663});
}
