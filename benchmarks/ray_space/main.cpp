// The tables of Leyvand et al. 2003 and our own:
//
//   ray_space_bench NAME... [--json FILE] [--smoke]
//
// NAME: urban (table 1), tightness (the same against an exact set), box-field (table 2), umbrae (table 3), resolution
// (table 4), city (table 5), components, bounds, or all. Scenes are generated, seed 1, or a real city where it is
// there. One core for the method; sampling uses all. Tables go to standard output, JSON to FILE.

#include "experiments.hpp"
#include "run_experiments.hpp"

using namespace visibility::bench;
namespace experiments = visibility::bench::ray_space;

int main(int argc, char** argv)
{
  std::vector<Experiment<experiments::Size>> const all{
    {"urban", experiments::urban},           {"tightness", experiments::tightness},
    {"box-field", experiments::box_field},   {"umbrae", experiments::umbrae},
    {"resolution", experiments::resolution}, {"city", experiments::city},
    {"components", experiments::components}, {"bounds", experiments::bounds}};
  return run_experiments("ray_space", all, argc, argv);
}
