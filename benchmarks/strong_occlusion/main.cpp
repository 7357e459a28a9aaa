// The experiments of Cohen-Or et al. 1998 and our own:
//
//   strong_occlusion_bench NAME... [--json FILE] [--smoke]
//
// NAME: cell-sizes (tables 1 and 2, figure 5), ranks (table 3), levels (table 4), spheres (table 5), optimizations,
// cities (real ones, where they are there), scale, or all. Other scenes are generated, seed 1. Tables go to standard
// output, JSON to FILE.

#include "experiments.hpp"

#include <cstring>
#include <functional>

using namespace visibility::bench;
namespace experiments = visibility::bench::strong_occlusion;

int main(int argc, char** argv)
{
  std::vector<std::pair<std::string, std::function<void(Report&, experiments::Size)>>> const all{
    {"cell-sizes", experiments::cell_sizes},
    {"ranks", experiments::ranks},
    {"levels", experiments::levels},
    {"spheres", experiments::spheres},
    {"optimizations", experiments::optimizations},
    {"cities", experiments::cities},
    {"scale", experiments::scale}};
  auto size = experiments::Size::full;
  std::string json, command = "strong_occlusion_bench";
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
  Report report("strong_occlusion", command);
  std::size_t run = 0;
  try {
    for (auto const& [name, experiment] : all)
      if (std::ranges::find(names, name) != names.end() || std::ranges::find(names, "all") != names.end()) {
        experiment(report, size);
        ++run;
      }
    if (run == 0 || (run < names.size() && run < all.size())) {
      std::cerr << "usage: strong_occlusion_bench NAME... [--json FILE] [--smoke]; NAME is all";
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
