#include "experiments.hpp"

#include "visibility/evidence/ray_scene.hpp"
#include "visibility/methods/sampling/method.hpp"
#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/generators.hpp"
#include "visibility/scene/read_scene.hpp"

#include <filesystem>

namespace visibility::bench::strong_occlusion {

namespace {

struct City {
  std::string file;             ///< below the folder of real scenes; or a generator, "gen:..."
  std::vector<Point3d> places;  ///< lower corners of cells of 4 x 4 x 2 m
};

std::vector<City> const cities_of_the_world{
  {"city/tokyo_akihabara.geojsonl", {{159.28, 889.76, 0.5}, {155.75, 979.90, 0.5}, {129.20, 906.38, 0.5}}},
  {"city/lyon1.geojson", {{1841948.79, 5176042.36, 170}, {1842324.21, 5176076.02, 170}, {1842417.07, 5176001.44, 170}}},
  {"city/rotterdam_centre.ply", {{699.95, -96.22, 0.5}, {703.74, 77.12, 0.5}, {1027.72, 502.44, 0.5}}},
  {"city/lower_manhattan.ply", {{-2389.30, -7634.57, 0.5}, {-2791.32, -7415.23, 0.5}, {-2991.51, -8015.78, 0.5}}},
  {"city/etoile.ply", {{0, 0, 0.5}, {-150, 100, 0.5}}},
  {"city/munich.ply", {{0, 0, 0.5}, {-200, -100, 0.5}}},
  {"cityjson/val3dity_3-20-DELFSHAVEN.city.json", {{90927.22, 435746.79, 1.5}, {90787.94, 435907.80, 1.5}}}};

}  // namespace

void cities(Report& report, Size size)
{
  auto& table =
    report.table("Real cities, cells of 4 x 4 x 2 m: without and with convex bodies inside non-convex objects",
                 {"city", "objects", "cell", "set without", "set with", "seen", "with / seen", "build without, s",
                  "build with, s", "query without, ms", "query with, ms"});
  std::vector<City> const sources =
    size == Size::full ? cities_of_the_world : std::vector<City>{{"gen:district", {{0, -10, 0.5}}}};
  for (auto const& city : sources) {
    bool const generated = city.file.starts_with("gen:");
    auto const path = std::filesystem::path(VISIBILITY_SCENES_DIR) / city.file;
    if (!generated && !std::filesystem::exists(path)) {
      table.notes.push_back(city.file + " is not there");
      continue;
    }
    Scene const scene = generated ? generate(city.file.substr(4)) : read_scene(path);
    std::optional<PreparedScene> plain, with;
    double const build_plain = median_seconds(1, 0, [&] { plain.emplace(scene); });
    double const build_with = median_seconds(1, 0, [&] { with.emplace(scene, InnerBodyOptions{}); });
    RayScene const rays(*plain);
    int number = 0;
    for (auto const& p : city.places) {
      ViewCell const cell(Box{p, {p.x + 4, p.y + 4, p.z + 2}});
      std::size_t loose = 0, tight = 0;
      int const runs = size == Size::full ? 5 : 1;
      double const query_plain =
        median_seconds(runs, 2, [&] { loose = StrongOcclusion<>()(*plain, cell).visible.size(); });
      double const query_with =
        median_seconds(runs, 2, [&] { tight = StrongOcclusion<>()(*with, cell).visible.size(); });
      auto const seen = Sampling({.rays = size == Size::full ? 3'000'000U : 10'000U})(rays, cell).visible.size();
      table.add({city.file, double(scene.objects.size()), double(++number), double(loose), double(tight), double(seen),
                 double(tight) / double(seen), build_plain, build_with, 1e3 * query_plain, 1e3 * query_with});
    }
  }
  table.notes.emplace_back(
    "Seen: objects with an exactly confirmed sight line, found with 3 million guided rays: a lower bound.");
}

}  // namespace visibility::bench::strong_occlusion
