#include "experiments.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/generators.hpp"

namespace visibility::bench::strong_occlusion {

namespace {

struct Case {
  std::string scene;
  double side;
  bool one_by_one;  ///< also each optimization alone: takes minutes in a large scene
};

void one_case(Report& report, Case const& c, int runs)
{
  Scene const scene = generate(c.scene);
  PreparedScene const prepared(scene);
  auto const cell = ground_cell(c.side);
  auto& table = report.table("Optimizations (section 5), " + c.scene + ", cell of side " + std::to_string(int(c.side)) +
                               ", face granularity",
                             {"optimizations", "visible", "targets", "candidates", "rays", "boxes probed", "ms"});
  std::vector<std::uint32_t> reference;
  auto const add = [&](std::string const& name, Options const& o) {
    PotentiallyVisibleSet set;
    double const seconds = median_seconds(runs, 2, [&] { set = StrongOcclusion<>(o)(prepared, cell); });
    if (reference.empty()) reference = set.visible;
    if (set.visible != reference) throw std::logic_error("'" + name + "' changes the set");
    auto const& s = set.statistics;
    table.add({name, double(set.visible.size()), s.at("targets"), s.at("candidates"), s.at("rays"), s.at("probes"),
               1e3 * seconds});
  };
  add("all", Options{});
  Options const none = Options::naive(Options{}.granularity);
  if (c.one_by_one) add("none", none);
  for (auto const& [name, flag] : visibility::strong_occlusion::optimizations) {
    if (!c.one_by_one) break;
    Options o = none;
    o.*flag = true;
    add("only " + std::string(name), o);
  }
  for (auto const& [name, flag] : visibility::strong_occlusion::optimizations) {
    if (!c.one_by_one && flag == &Options::leading_ray) continue;  // minutes
    Options o;
    o.*flag = false;
    add("all but " + std::string(name), o);
  }
}

}  // namespace

void optimizations(Report& report, Size size)
{
  if (size == Size::smoke) return one_case(report, {city(size), 20, true}, 1);
  for (auto const& c : {Case{"city", 80, true}, Case{"city", 20, true}, Case{"city,n=751000", 20, false}})
    one_case(report, c, 21);
}

}  // namespace visibility::bench::strong_occlusion
