#include "methods.hpp"

#include "count_option.hpp"

#include "visibility/methods/sampling/method.hpp"
#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <stdexcept>

namespace visibility::commands {

namespace {

using strong_occlusion::optimizations;

strong_occlusion::Options strong_occlusion_options(MethodArguments const& a)
{
  strong_occlusion::Options options;
  options.granularity = strong_occlusion::granularity_from_string(a.granularity);
  for (auto const& [name, optimization] : optimizations)
    if (std::ranges::find(a.without, name) != a.without.end()) options.*optimization = false;
  return options;
}

template <Arithmetic A>
std::vector<CellSet> refine_strong_occlusion(strong_occlusion::Options fine, strong_occlusion::Granularity coarse,
                                             PreparedScene const& scene, Partition const& partition,
                                             std::function<void(std::uint64_t)> const& progress)
{
  std::vector<StrongOcclusion<A>> methods(partition.levels(), StrongOcclusion<A>(fine));
  fine.granularity = std::min(fine.granularity, coarse);
  std::fill(methods.begin(), methods.end() - 1, StrongOcclusion<A>(fine));
  return std::move(visibility::refine(scene, partition, methods, [&](std::size_t) { progress(1); }).back());
}

void require_one_of(std::string const& option, std::string const& value, std::vector<std::string> const& valid)
{
  if (std::ranges::find(valid, value) != valid.end()) return;
  std::string text = option + " '" + value + "' is not one of";
  for (auto const& v : valid) text += (&v == &valid.front() ? " " : ", ") + v;
  throw BadInput(text);
}

}  // namespace

std::vector<std::string> method_names() { return {"strong-occlusion", "sampling"}; }

void MethodArguments::add_to(CLI::App& command)
{
  command.add_option("--method", method, "strong-occlusion (default) or sampling");
  command.add_option("--arithmetic", arithmetic, "filtered (default), rational or double");
  command.add_option("--granularity", granularity, "strong-occlusion: object, part, face (default) or triangle");
  command.add_option("--coarse-granularity", coarse_granularity,
                     "strong-occlusion: the same for all but the smallest --cell-size (default part)");
  command.add_flag("--no-inner-bodies", no_inner_bodies,
                   "strong-occlusion: do not look for convex occluders inside non-convex objects");
  std::string names;
  for (auto const& [name, optimization] : optimizations) names += (names.empty() ? "" : ", ") + std::string(name);
  command.add_option("--without", without, "strong-occlusion: optimizations to switch off (" + names + ")")
    ->delimiter(',');
  add_count_option(command, "--rays", rays, "sampling: rays to shoot (default 1000000)");
  command.add_option("--seconds", seconds, "sampling: stop after this time (default 0: no limit)");
  command.add_option("--seed", seed, "sampling: seed (default 1)");
}

void MethodArguments::validate() const
{
  require_one_of("--method", method, method_names());
  require_one_of("--arithmetic", arithmetic, {"filtered", "rational", "double"});
  std::vector<std::string> const granularities{"object", "part", "face", "triangle"};
  require_one_of("--granularity", granularity, granularities);
  require_one_of("--coarse-granularity", coarse_granularity, granularities);
  std::vector<std::string> names;
  for (auto const& [name, optimization] : optimizations) names.emplace_back(name);
  for (auto const& name : without) require_one_of("--without", name, names);
  if (method == "sampling" && arithmetic != "filtered")
    throw BadInput("--arithmetic does not apply to sampling: its witnesses are always confirmed exactly");
  if (method != "strong-occlusion" && !without.empty()) throw BadInput("--without applies to strong-occlusion only");
  if (!(seconds >= 0)) throw BadInput("--seconds must not be negative");
}

void MethodArguments::prepare(std::optional<PreparedScene>& prepared, Scene const& scene) const
{
  if (method == "strong-occlusion" && !no_inner_bodies)
    prepared.emplace(scene, InnerBodyOptions{});
  else
    prepared.emplace(scene);
}

std::map<std::string, std::string> MethodArguments::options() const
{
  if (method == "sampling")
    return {{"rays", std::to_string(rays)}, {"seconds", std::to_string(seconds)}, {"seed", std::to_string(seed)}};
  std::map<std::string, std::string> out{{"granularity", granularity},
                                         {"inner-bodies", no_inner_bodies ? "off" : "on"}};
  auto const options = strong_occlusion_options(*this);
  for (auto const& [name, optimization] : optimizations) out[std::string(name)] = options.*optimization ? "on" : "off";
  return out;
}

MethodRunner::MethodRunner(MethodArguments arguments, PreparedScene const& scene)
  : arguments_(std::move(arguments)), scene_(scene)
{
  if (arguments_.method == "sampling") rays_.emplace(scene);
}

PotentiallyVisibleSet MethodRunner::operator()(ViewCell const& cell,
                                               std::function<void(std::uint64_t)> const& progress) const
{
  if (rays_)
    return Sampling(
      {.rays = arguments_.rays, .seconds = arguments_.seconds, .seed = arguments_.seed, .progress = progress})(*rays_,
                                                                                                               cell);
  auto const options = strong_occlusion_options(arguments_);
  auto const run = [&] {
    if (arguments_.arithmetic == "rational") return StrongOcclusion<Rational>(options)(scene_, cell);
    if (arguments_.arithmetic == "double") return StrongOcclusion<Double>(options)(scene_, cell);
    return StrongOcclusion<Filtered>(options)(scene_, cell);
  };
  auto set = run();
  progress(1);
  return set;
}

std::vector<CellSet> MethodRunner::refine(Partition const& partition,
                                          std::function<void(std::uint64_t)> const& progress) const
{
  if (arguments_.method != "strong-occlusion")
    throw BadInput("--method " + arguments_.method + " cannot refine cells: give --cell-size once");
  auto const options = strong_occlusion_options(arguments_);
  auto const coarse = strong_occlusion::granularity_from_string(arguments_.coarse_granularity);
  if (arguments_.arithmetic == "rational")
    return refine_strong_occlusion<Rational>(options, coarse, scene_, partition, progress);
  if (arguments_.arithmetic == "double")
    return refine_strong_occlusion<Double>(options, coarse, scene_, partition, progress);
  return refine_strong_occlusion<Filtered>(options, coarse, scene_, partition, progress);
}

std::uint64_t MethodRunner::steps_per_cell() const { return rays_ ? arguments_.rays : 1; }

}  // namespace visibility::commands
