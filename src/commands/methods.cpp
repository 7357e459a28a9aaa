#include "methods.hpp"

#include "count_option.hpp"

#include "visibility/methods/exact_25d/method.hpp"
#include "visibility/methods/extended_projection/method.hpp"
#include "visibility/methods/extended_projection/sweep.hpp"
#include "visibility/methods/ray_space/method.hpp"
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

ray_space::Options ray_space_options(MethodArguments const& a)
{
  ray_space::Options options;
  if (a.resolution) options.resolution = *a.resolution;
  options.components = a.components;
  options.umbra = a.umbra == "half" ? ray_space::Umbra::half : ray_space::Umbra::full;
  options.bounds = a.bounds == "linear" ? ray_space::Bounds::linear : ray_space::Bounds::exact;
  options.granularity = ray_space::granularity_from_string(a.granularity);
  return options;
}

extended_projection::Options projection_options(MethodArguments const& a)
{
  auto options = a.projection;
  if (a.resolution) options.resolution = *a.resolution;
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

std::vector<std::string> method_names()
{
  return {"strong-occlusion", "exact-2.5d", "extended-projection", "occlusion-sweep", "ray-space", "sampling"};
}

std::vector<std::string> applicable_methods(Scene const& scene)
{
  auto names = method_names();
  if (!scene.balls.empty() || HeightField(scene).raised() > 0) std::erase(names, "exact-2.5d");
  return names;
}

namespace {

bool projects(std::string const& method) { return method == "extended-projection" || method == "occlusion-sweep"; }

void add_projection_options(CLI::App& command, extended_projection::Options& o)
{
  command.add_option("--extent", o.extent,
                     "extended-projection: how far planes reach beyond the cell, in distances (default 1.5)");
  command.add_option("--planes", o.planes,
                     "extended-projection: planes in each direction, at most (default 8, 15 for occlusion-sweep)");
  command.add_option("--kernel", o.kernel,
                     "occlusion-sweep: pixels of the cell's image from plane to plane (default 5)");
  command
    .add_option("--plane-distances", o.distances,
                "extended-projection: distances of the planes from the cell, in place of chosen ones")
    ->delimiter(',');
  command.add_option("--occluders", o.occluders,
                     "extended-projection: convex bodies of the largest solid angle to project (default 1000)");
  command.add_flag("!--no-more-occluders", o.more_occluders,
                   "extended-projection: do not add those of objects that are still visible");
  command.add_flag("!--no-improved", o.improved, "extended-projection: without the improved Projection of occludees");
}

std::map<std::string, std::string> text_of(extended_projection::Options const& o)
{
  std::string distances;
  for (double const d : o.distances) distances += (distances.empty() ? "" : ",") + std::to_string(d);
  std::map<std::string, std::string> out{
    {"resolution", std::to_string(o.resolution)}, {"extent", std::to_string(o.extent)},
    {"occluders", std::to_string(o.occluders)},   {"more-occluders", o.more_occluders ? "on" : "off"},
    {"kernel", std::to_string(o.kernel)},         {"improved", o.improved ? "on" : "off"}};
  if (distances.empty())
    out["planes"] = std::to_string(o.planes);
  else
    out["plane-distances"] = distances;
  return out;
}

}  // namespace

void MethodArguments::add_to(CLI::App& command)
{
  command.add_option(
    "--method", method,
    "strong-occlusion (default), exact-2.5d, extended-projection, occlusion-sweep, ray-space or sampling");
  command.add_option("--arithmetic", arithmetic, "filtered (default), rational or double");
  command.add_option("--granularity", granularity,
                     "strong-occlusion, ray-space: object, part, face (default) or triangle");
  command.add_option("--coarse-granularity", coarse_granularity,
                     "strong-occlusion: the same for all but the smallest --cell-size (default part)");
  command.add_flag(
    "--no-inner-bodies", no_inner_bodies,
    "strong-occlusion, extended-projection, ray-space: do not look for convex occluders inside non-convex "
    "objects");
  command.add_option("--resolution", resolution,
                     "extended-projection, ray-space: pixels of a map along a side (default 256, ray-space 512)");
  command.add_option("--components", components, "ray-space: umbrae kept in each pixel (default 2)");
  command.add_option("--umbra", umbra, "ray-space: full (default), or half: what no sight line passes below");
  command.add_option("--bounds", bounds, "ray-space: exact (default) or linear, the paper's approximation");
  std::string names;
  for (auto const& [name, optimization] : optimizations) names += (names.empty() ? "" : ", ") + std::string(name);
  command.add_option("--without", without, "strong-occlusion: optimizations to switch off (" + names + ")")
    ->delimiter(',');
  command.add_flag("--witnesses", witnesses, "exact-2.5d: write a sight line to every visible object");
  command.add_option(
    "--occludees", occludees,
    "exact-2.5d: look for the objects of this scene (file or gen:...), which hide nothing, instead of those of "
    "SCENE");
  command.add_option("--explain", explain,
                     "exact-2.5d: write visible parts of edges, funnels and shadow planes to this file (JSON)");
  add_projection_options(command, projection);
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
  require_one_of("--umbra", umbra, {"half", "full"});
  require_one_of("--bounds", bounds, {"exact", "linear"});
  if (method == "ray-space" && arithmetic != "filtered")
    throw BadInput("--arithmetic does not apply to ray-space: it rounds every bound to the safe side");
  if (method == "ray-space") try {
      ray_space_options(*this).validate();
    } catch (std::invalid_argument const& e) {
      throw BadInput("--method " + std::string(e.what()));
    }
  if (method == "sampling" && arithmetic != "filtered")
    throw BadInput("--arithmetic does not apply to sampling: its witnesses are always confirmed exactly");
  if (projects(method)) {
    if (arithmetic != "filtered")
      throw BadInput("--arithmetic does not apply to " + method + ": it rounds to the safe side");
    try {
      projection_options(*this).validate();
    } catch (std::invalid_argument const& e) {
      throw BadInput("--method " + method + ": " + e.what());
    }
  }
  if (method != "strong-occlusion" && !without.empty()) throw BadInput("--without applies to strong-occlusion only");
  if (method != "exact-2.5d" && witnesses) throw BadInput("--witnesses applies to exact-2.5d only");
  if (method != "exact-2.5d" && !occludees.empty()) throw BadInput("--occludees applies to exact-2.5d only");
  if (method != "exact-2.5d" && !explain.empty()) throw BadInput("--explain applies to exact-2.5d only");
  if (!explain.empty() && !occludees.empty())
    throw BadInput("--explain is of the scene's own edges: leave out --occludees");
  if (!explain.empty() && arithmetic == "double") throw BadInput("--explain needs exact arithmetic");
  if (!(seconds >= 0)) throw BadInput("--seconds must not be negative");
}

std::map<std::string, std::string> MethodArguments::options() const
{
  if (method == "sampling")
    return {{"rays", std::to_string(rays)}, {"seconds", std::to_string(seconds)}, {"seed", std::to_string(seed)}};
  if (method == "exact-2.5d") return {};
  if (projects(method)) {
    auto out = text_of(projection_options(*this));
    out["inner-bodies"] = no_inner_bodies ? "off" : "on";
    return out;
  }
  if (method == "ray-space")
    return {{"resolution", std::to_string(ray_space_options(*this).resolution)},
            {"components", std::to_string(components)},
            {"umbra", umbra},
            {"bounds", bounds},
            {"granularity", granularity},
            {"inner-bodies", no_inner_bodies ? "off" : "on"}};
  std::map<std::string, std::string> out{{"granularity", granularity},
                                         {"inner-bodies", no_inner_bodies ? "off" : "on"}};
  auto const options = strong_occlusion_options(*this);
  for (auto const& [name, optimization] : optimizations) out[std::string(name)] = options.*optimization ? "on" : "off";
  return out;
}

namespace {

/// Below a column that ends above the ground sight lines pass that a height field does not know.
void require_height_field(HeightField const& field)
{
  if (field.raised() == 0) return;
  throw BadInput("--method exact-2.5d: " + std::to_string(field.raised()) +
                 " objects end above the lowest point of the scene, so it is not a height field as it is; give "
                 "--grounded to have everything below an upper surface count as solid");
}

}  // namespace

MethodRunner::MethodRunner(MethodArguments arguments, Scene const& scene, Scene const* occludees)
  : arguments_(std::move(arguments))
{
  if (arguments_.method == "exact-2.5d") {
    height_field_.emplace(scene);
    require_height_field(*height_field_);
    if (occludees != nullptr) occludees_.emplace(targets_.emplace(*occludees));
  } else if (arguments_.method != "sampling" && !arguments_.no_inner_bodies) {
    scene_.emplace(scene, InnerBodyOptions{});
  } else {
    scene_.emplace(scene);
  }
  if (arguments_.method == "sampling") rays_.emplace(*scene_);
}

PotentiallyVisibleSet MethodRunner::operator()(ViewCell const& cell,
                                               std::function<void(std::uint64_t)> const& progress) const
{
  if (rays_)
    return Sampling(
      {.rays = arguments_.rays, .seconds = arguments_.seconds, .seed = arguments_.seed, .progress = progress})(*rays_,
                                                                                                               cell);
  auto set = one_cell(cell);
  progress(1);
  return set;
}

PotentiallyVisibleSet MethodRunner::one_cell(ViewCell const& cell) const
{
  if (height_field_) return exact_25d(cell);
  if (arguments_.method == "occlusion-sweep") return OcclusionSweep(projection_options(arguments_))(*scene_, cell);
  if (arguments_.method == "extended-projection")
    return ExtendedProjection(projection_options(arguments_))(*scene_, cell);
  if (arguments_.method == "ray-space") return RaySpace(ray_space_options(arguments_))(*scene_, cell);
  return strong_occlusion(cell);
}

template <Arithmetic A>
PotentiallyVisibleSet MethodRunner::exact_25d(ViewCell const& cell) const
{
  exact_25d::Options options;
  options.witnesses = arguments_.witnesses;
  Exact25d<A> const method(options);
  return occludees_ ? method(*height_field_, *occludees_, cell) : method(*height_field_, cell);
}

PotentiallyVisibleSet MethodRunner::exact_25d(ViewCell const& cell) const
{
  require_above_ground(cell);
  if (arguments_.arithmetic == "rational") return exact_25d<Rational>(cell);
  if (arguments_.arithmetic == "double") return exact_25d<Double>(cell);
  return exact_25d<Filtered>(cell);
}

std::pair<PotentiallyVisibleSet, exact_25d::Explanation> MethodRunner::explain(ViewCell const& cell) const
{
  require_above_ground(cell);
  exact_25d::Options options;
  options.witnesses = arguments_.witnesses;
  if (arguments_.arithmetic == "rational") return Exact25d<Rational>(options).explain(*height_field_, cell);
  return Exact25d<Filtered>(options).explain(*height_field_, cell);
}

void MethodRunner::require_above_ground(ViewCell const& cell) const
{
  if (cell.bounds().min.z < height_field_->ground())
    throw BadInput("--method exact-2.5d: a cell reaches below the lowest point of the scene, z = " +
                   std::to_string(height_field_->ground()));
}

PotentiallyVisibleSet MethodRunner::strong_occlusion(ViewCell const& cell) const
{
  auto const options = strong_occlusion_options(arguments_);
  if (arguments_.arithmetic == "rational") return StrongOcclusion<Rational>(options)(*scene_, cell);
  if (arguments_.arithmetic == "double") return StrongOcclusion<Double>(options)(*scene_, cell);
  return StrongOcclusion<Filtered>(options)(*scene_, cell);
}

std::vector<CellSet> MethodRunner::refine(Partition const& partition,
                                          std::function<void(std::uint64_t)> const& progress) const
{
  if (arguments_.method != "strong-occlusion")
    throw BadInput("--method " + arguments_.method + " cannot refine cells: give --cell-size once");
  auto const options = strong_occlusion_options(arguments_);
  auto const coarse = strong_occlusion::granularity_from_string(arguments_.coarse_granularity);
  if (arguments_.arithmetic == "rational")
    return refine_strong_occlusion<Rational>(options, coarse, *scene_, partition, progress);
  if (arguments_.arithmetic == "double")
    return refine_strong_occlusion<Double>(options, coarse, *scene_, partition, progress);
  return refine_strong_occlusion<Filtered>(options, coarse, *scene_, partition, progress);
}

std::uint64_t MethodRunner::steps_per_cell() const { return rays_ ? arguments_.rays : 1; }

}  // namespace visibility::commands
