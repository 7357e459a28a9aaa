// The experiments of Cohen-Or et al. 1998 and our own:
//
//   strong_occlusion_bench NAME... [--json FILE] [--smoke]
//
// NAME: cell-sizes (tables 1 and 2, figure 5), ranks (table 3), levels (table 4), spheres (table 5), optimizations,
// cities (real ones, where they are there), scale, or all. Other scenes are generated, seed 1. Tables go to standard
// output, JSON to FILE.

#include "experiments.hpp"
#include "run_experiments.hpp"

using namespace visibility::bench;
namespace experiments = visibility::bench::strong_occlusion;

int main(int argc, char** argv)
{
  std::vector<Experiment<experiments::Size>> const all{{"cell-sizes", experiments::cell_sizes},
                                                       {"ranks", experiments::ranks},
                                                       {"levels", experiments::levels},
                                                       {"spheres", experiments::spheres},
                                                       {"optimizations", experiments::optimizations},
                                                       {"cities", experiments::cities},
                                                       {"scale", experiments::scale}};
  return run_experiments("strong_occlusion", all, argc, argv);
}
