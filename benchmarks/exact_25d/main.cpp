// The experiments of Bittner et al. 2005 and our own:
//
//   exact_25d_bench NAME... [--json FILE] [--smoke]
//
// NAME: models (table 1), cells (table 2), stages (table 3), wedges (section 6.2), sampling (table 4), grid (section
// 6.3), growth (figure 6), embree, double, or all. Scenes are generated, seed 1, or real cities where they are there.
// Cells stand at random free places, seed 1. One core. Tables go to standard output, JSON to FILE.

#include "experiments.hpp"
#include "run_experiments.hpp"

using namespace visibility::bench;
namespace experiments = visibility::bench::exact_25d;

int main(int argc, char** argv)
{
  std::vector<Experiment<experiments::Size>> const all{
    {"models", experiments::models}, {"cells", experiments::cells},       {"stages", experiments::stages},
    {"wedges", experiments::wedges}, {"sampling", experiments::sampling}, {"grid", experiments::grid},
    {"growth", experiments::growth}, {"embree", experiments::embree},     {"double", experiments::double_arithmetic}};
  return run_experiments("exact_25d", all, argc, argv);
}
