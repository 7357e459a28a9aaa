#include "ends.hpp"
#include "scenes.hpp"

#include "visibility/evidence/ray_scene.hpp"
#include "visibility/methods/sampling/method.hpp"
#include "visibility/scene/grounded.hpp"
#include "visibility/scene/prepared_scene.hpp"

#include <stdexcept>

namespace visibility::bench::exact_25d {

namespace {

struct Place {
  std::string scene;
  double perimeter, height;
  int cells;
};

}  // namespace

void embree(Report& report, Size size)
{
  bool const full = size == Size::full;
  auto& table = report.table("Guided sampling in 1, 10 and 100 times the time of the exact method, one core each",
                             {"scene", "perimeter", "visible", "exact, ms", "recall x 1, %", "rays", "x 10, %", "rays",
                              "x 100, %", "rays", "ms taken"});
  std::vector<Place> const places =
    full ? std::vector<Place>{{"gen:city,n=3000,base=40,street=11.6,low=12,high=25", 36, 2, 2},
                              {"city/tokyo_chuo.geojsonl.gz", 36, 2, 1},
                              {"city/rotterdam_centre.ply", 36, 2, 1},
                              {"gen:city,n=17000,base=20,street=23.4,low=4,high=30", 89, 2, 1},
                              {"gen:slanted", 36, 4, 1},
                              {big_city(size), 64, 2, 1}}
         : std::vector<Place>{{"gen:slanted,n=100", 36, 2, 1}};
  for (auto const& place : places) {
    auto const m = load(place.scene);
    if (!m) {
      table.notes.push_back(place.scene + " is not there");
      continue;
    }
    // What a height field takes for solid must be solid for rays too.
    Scene const solid = m->field->raised() > 0 ? grounded(m->scene) : Scene{};
    PreparedScene const prepared(m->field->raised() > 0 ? solid : m->scene);
    RayScene const rays(prepared);
    for (auto const& cell : answered_cells(*m, {place.perimeter, place.height}, place.cells, table.notes)) {
      auto const set = exact_set(*m->field, cell);
      double const seconds = median_seconds<ProcessorClock>(full ? 5 : 1, 1, [&] { Exact25d<>()(*m->field, cell); });
      std::vector<Value> row{m->name, place.perimeter, double(set.visible.size()), 1e3 * seconds};
      double spent = 0;
      for (double const factor : {1.0, 10.0, 100.0}) {
        PotentiallyVisibleSet seen;
        auto const rays_in = [&](std::uint64_t n) {
          return median_seconds<ProcessorClock>(1, 0, [&] { seen = Sampling({.rays = n, .threads = 1})(rays, cell); });
        };
        // As many rays as take that long, from what fewer took.
        double rate = 20'000 / rays_in(20'000);
        for (int i = 0; i < (factor < 100 ? 2 : 1); ++i) {
          auto const n = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(rate * factor * seconds));
          spent = rays_in(n);
          rate = static_cast<double>(n) / spent;
        }
        if (!difference(seen.visible, set.visible).empty())
          throw std::runtime_error(m->name + ": a sight line reaches an object that the exact set lacks");
        row.emplace_back(100 * double(seen.visible.size()) / double(set.visible.size()));
        row.emplace_back(seen.statistics.at("rays"));
      }
      row.emplace_back(1e3 * spent);
      table.add(std::move(row));
    }
  }
  table.notes.insert(table.notes.begin(), {"Every object that a ray proposes is confirmed exactly and must be in the",
                                           "exact set. Processor time; building the ray scene is not counted."});
}

}  // namespace visibility::bench::exact_25d
