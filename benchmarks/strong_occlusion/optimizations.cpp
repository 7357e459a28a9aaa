#include "experiments.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/generators.hpp"

namespace visibility::bench::strong_occlusion {

void optimizations(Report& report, Size size)
{
  Scene const scene = generate(city(size));
  PreparedScene const prepared(scene);
  std::vector<double> const sides = size == Size::full ? std::vector<double>{80, 20} : std::vector<double>{20};
  for (double const side : sides) {
    auto const cell = ground_cell(side);
    auto& table =
      report.table("Optimizations (section 5), cell of side " + std::to_string(int(side)) + ", face granularity",
                   {"optimizations", "visible", "targets", "candidates", "rays", "boxes probed", "ms"});
    std::vector<std::uint32_t> reference;
    auto const add = [&](std::string const& name, Options const& o) {
      PotentiallyVisibleSet set;
      double const seconds =
        median_seconds(size == Size::full ? 21 : 1, 2, [&] { set = StrongOcclusion<>(o)(prepared, cell); });
      if (reference.empty()) reference = set.visible;
      if (set.visible != reference) throw std::logic_error("'" + name + "' changes the set");
      auto const& s = set.statistics;
      table.add({name, double(set.visible.size()), s.at("targets"), s.at("candidates"), s.at("rays"), s.at("probes"),
                 1e3 * seconds});
    };
    Options const none = Options::naive(Options{}.granularity);
    add("all", Options{});
    add("none", none);
    for (auto const& [name, flag] : switches()) {
      Options o = none;
      o.*flag = true;
      add("only " + name, o);
    }
    for (auto const& [name, flag] : switches()) {
      Options o;
      o.*flag = false;
      add("all but " + name, o);
    }
  }
}

}  // namespace visibility::bench::strong_occlusion
