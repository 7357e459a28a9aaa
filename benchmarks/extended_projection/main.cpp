// The experiments of Durand et al. 2000 and our own:
//
//   extended_projection_bench NAME... [--json FILE] [--smoke]
//
// NAME: resolution (figure 12), growth (figure 13), improved, city and streets (section 7.1), reprojection
// (section 5.1), oriented and tilted (section 2.4), lim (section 7.4), forest (section 7.2), truth, error, or all.
// Scenes are generated, seed 1. One core; times are processor time. Tables go to standard output, JSON to FILE.

#include "experiments.hpp"
#include "run_experiments.hpp"

using namespace visibility::bench;
namespace experiments = visibility::bench::extended_projection;

int main(int argc, char** argv)
{
  std::vector<Experiment<experiments::Size>> const all{{"resolution", experiments::resolution},
                                                       {"growth", experiments::growth},
                                                       {"improved", experiments::improved},
                                                       {"oriented", experiments::oriented},
                                                       {"tilted", experiments::tilted},
                                                       {"reprojection", experiments::reprojection},
                                                       {"lim", experiments::lim},
                                                       {"city", experiments::city},
                                                       {"streets", experiments::streets},
                                                       {"forest", experiments::forest},
                                                       {"truth", experiments::truth},
                                                       {"error", experiments::error}};
  return run_experiments("extended_projection", all, argc, argv);
}
