#include "support/catch.hpp"
#include "support/real_scenes.hpp"

#include "visibility/scene/read_scene.hpp"

using namespace visibility;

TEST_CASE("real files: counts", "[readers][.print]")
{
  for (auto const* name : {"city/etoile.ply", "city/munich.ply", "city/lower_manhattan.ply", "city/rotterdam_centre.ply",
                           "city/tokyo_akihabara.geojsonl", "city/tokyo_chuo.geojsonl.gz", "city/tokyo_central6.geojsonl.gz", "city/lyon1.geojson",
                           "interior/hospital_floor_01.obj", "cityjson/3dfier_testarea.json", "cityjson/cjio_DH_01_subs.city.json",
                           "cityjson/cjio_delft.json", "cityjson/cjio_rotterdam_subset.json", "cityjson/cjio_zurich_subset_lod2.json",
                           "cityjson/kriger_citjsnClean_uEstate10m.json", "cityjson/loader_3db_sub.json", "cityjson/rhino_Rotterdam.json",
                           "cityjson/val3dity_3-20-DELFSHAVEN.city.json"}) {
    auto const path = test::real_scene(name);
    if (!path) continue;
    auto const start = std::chrono::steady_clock::now();
    Scene const s = read_scene(*path);
    auto const t = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    s.validate();
    std::printf("%-45s %6zu objects %7zu triangles %7zu prisms %7zu vertices %.3f s\n", name, s.objects.size(), s.triangles.size(), s.prisms.size(), s.vertices.size(), t);
    for (auto const& n : s.notes) std::printf("      %s\n", n.c_str());
  }
}
