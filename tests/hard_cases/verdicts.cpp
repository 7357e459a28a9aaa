#include "verdicts.hpp"

#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/methods/ray_space/method.hpp"
#include "visibility/methods/sampling/method.hpp"
#include "visibility/methods/strong_occlusion/method.hpp"

#include <algorithm>

namespace visibility::hard_cases {

namespace {

Verdict judge(HardCase const& c, std::string method, std::string arithmetic, PotentiallyVisibleSet const& set)
{
  std::vector<std::string> said, truth = c.visible;
  for (auto const o : set.visible) said.push_back(c.scene.objects[o].name);
  std::ranges::sort(said);
  std::ranges::sort(truth);
  Verdict v{std::move(method), std::move(arithmetic), set.guarantee, {}, {}};
  std::ranges::set_difference(truth, said, std::back_inserter(v.missing));
  std::ranges::set_difference(said, truth, std::back_inserter(v.extra));
  return v;
}

}  // namespace

std::vector<Verdict> verdicts(HardCase const& c)
{
  std::vector<Verdict> out;
  auto const add = [&](char const* method, char const* arithmetic, PotentiallyVisibleSet const& set) {
    out.push_back(judge(c, method, arithmetic, set));
  };
  if (c.is_height_field) {
    HeightField const field(c.scene);
    add("exact-2.5d", "filtered", Exact25d<Filtered>()(field, c.cell));
    add("exact-2.5d", "rational", Exact25d<Rational>()(field, c.cell));
    add("exact-2.5d", "double", Exact25d<Double>()(field, c.cell));
  }
  PreparedScene const scene(c.scene);
  add("strong-occlusion", "filtered", StrongOcclusion<Filtered>()(scene, c.cell));
  add("strong-occlusion", "rational", StrongOcclusion<Rational>()(scene, c.cell));
  add("strong-occlusion", "double", StrongOcclusion<Double>()(scene, c.cell));
  add("extended-projection", "rounded", ExtendedProjection()(scene, c.cell));
  add("occlusion-sweep", "rounded", OcclusionSweep()(scene, c.cell));
  add("ray-space", "rounded", RaySpace()(scene, c.cell));
  sampling::Options options;
  options.rays = 20'000;
  options.threads = 1;
  add("sampling", "confirmed", Sampling(options)(scene, c.cell));
  return out;
}

}  // namespace visibility::hard_cases
