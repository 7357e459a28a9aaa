#include "experiments.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/generators.hpp"

namespace visibility::bench::strong_occlusion {

void scale(Report& report, Size size)
{
  auto& table = report.table(
    "Scene size: a 20-unit cell at street level, one core",
    {"boxes", "build, s", "cell", "visible", "query, ms", "us per visible", "double, ms", "exact / double"});
  struct Place {
    char const* name;
    double x, y;
  };
  for (auto const* specification :
       size == Size::full ? std::vector{"city,n=7500", "city,n=75000", "city,n=751000"} : std::vector{"city,n=300"}) {
    Scene const scene = generate(specification);
    std::optional<PreparedScene> prepared;
    double const build = median_seconds(3, 5, [&] {
      prepared.reset();
      prepared.emplace(scene);
    });
    for (auto const& place : {Place{"crossing of two streets", 0, 0}, Place{"street", 13, 437},
                              Place{"open ground", 130, 130}, Place{"line through corners", 0, 500}}) {
      auto const cell = ground_cell(20, place.x, place.y);
      std::size_t visible = 0;
      auto const [e, d] = medians_in_turn(
        size == Size::full ? 15 : 1, [&] { visible = StrongOcclusion<>()(*prepared, cell).visible.size(); },
        [&] { StrongOcclusion<Double>()(*prepared, cell); });
      table.add({double(scene.boxes.size()), build, place.name, double(visible), 1e3 * e, 1e6 * e / double(visible),
                 1e3 * d, e / d});
    }
  }
  table.notes = {
    "Build: convex bodies and hierarchies of the whole scene, once. Streets are endless, so what is visible along",
    "them grows with the square root of the number of boxes, and so do the boundaries between the umbrae of two",
    "buildings, along which objects must be looked at one by one. Line through corners: at 45 degrees the cell looks "
    "along",
    "a line that touches building after building at a corner; thousands of objects beside it are hidden by no single",
    "building, and every box along it is a candidate for each of them."};
}

}  // namespace visibility::bench::strong_occlusion
