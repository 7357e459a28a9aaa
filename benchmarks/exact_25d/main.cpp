// The experiments of Bittner et al. 2005 and our own:
//
//   exact_25d_bench NAME... [--json FILE] [--smoke]
//
// NAME: models (table 1), cells (table 2), stages (table 3), wedges (section 6.2), sampling (table 4), growth (figure
// 6), embree, double, or all. Scenes are generated, seed 1, or real cities where they are there. Cells stand at random
// free places, seed 1. One core. Tables go to standard output, JSON to FILE.

#include "experiments.hpp"

#include <cstring>
#include <functional>

using namespace visibility::bench;
namespace experiments = visibility::bench::exact_25d;

int main(int argc, char** argv)
{
  std::vector<std::pair<std::string, std::function<void(Report&, experiments::Size)>>> const all{
    {"models", experiments::models},     {"cells", experiments::cells},
    {"stages", experiments::stages},     {"wedges", experiments::wedges},
    {"sampling", experiments::sampling}, {"growth", experiments::growth},
    {"embree", experiments::embree},     {"double", experiments::double_arithmetic}};
  auto size = experiments::Size::full;
  std::string json, command = "exact_25d_bench";
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    command += std::string(" ") + argv[i];
    if (std::strcmp(argv[i], "--smoke") == 0)
      size = experiments::Size::smoke;
    else if (std::strcmp(argv[i], "--json") == 0 && i + 1 < argc)
      json = argv[++i];
    else
      names.emplace_back(argv[i]);
  }
  Report report("exact_25d", command);
  std::size_t run = 0;
  try {
    for (auto const& [name, experiment] : all)
      if (std::ranges::find(names, name) != names.end() || std::ranges::find(names, "all") != names.end()) {
        experiment(report, size);
        ++run;
      }
    if (run == 0 || (run < names.size() && run < all.size())) {
      std::cerr << "usage: exact_25d_bench NAME... [--json FILE] [--smoke]; NAME is all";
      for (auto const& [name, experiment] : all) std::cerr << ", " << name;
      std::cerr << '\n';
      return 2;
    }
    report.print(std::cout);
    if (!json.empty()) report.write_json(json);
  } catch (std::exception const& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
