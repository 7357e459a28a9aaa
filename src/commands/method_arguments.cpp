#include "method_arguments.hpp"

#include "count_option.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <stdexcept>

namespace visibility::commands {

namespace {

bool projects(std::string const& method) { return method == "extended-projection" || method == "occlusion-sweep"; }

}  // namespace

using strong_occlusion::optimizations;

std::vector<std::string> method_names()
{
  return {"strong-occlusion", "exact-2.5d", "extended-projection", "occlusion-sweep", "ray-space", "sampling"};
}

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
  options.coarse = a.coarse;
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

bool uses_slices(MethodArguments const& a) { return projects(a.method) && a.projection.slices; }

namespace {

void require_one_of(std::string const& option, std::string const& value, std::vector<std::string> const& valid)
{
  if (std::ranges::find(valid, value) != valid.end()) return;
  std::string text = option + " '" + value + "' is not one of";
  for (auto const& v : valid) text += (&v == &valid.front() ? " " : ", ") + v;
  throw BadInput(text);
}

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
  command
    .add_option("--directions", o.directions,
                "planes along the sides of a cell that is a turned or tilted box (cell) or along the axes "
                "(axes); default automatic")
    ->transform(CLI::CheckedTransformer(
      std::map<std::string, extended_projection::Directions>{{"automatic", extended_projection::Directions::automatic},
                                                             {"cell", extended_projection::Directions::cell},
                                                             {"axes", extended_projection::Directions::axes}}));
  command.add_flag_callback(
    "--convolution", [&o] { o.reprojection = extended_projection::Reprojection::convolution; },
    "occlusion-sweep: from plane to plane by one kernel for all pixels, as the paper does");
  command.add_flag("--infinity", o.infinity,
                   "extended-projection: one plane at infinity in each direction, the fuzzy projection of Lim");
  command.add_option("--depth", o.depth, "extended-projection: depths of occluders by part (default), or by pixel")
    ->transform(CLI::CheckedTransformer(std::map<std::string, extended_projection::PartDepth>{
      {"part", extended_projection::PartDepth::part}, {"pixel", extended_projection::PartDepth::pixel}}));
  command.add_flag("!--no-slices", o.slices, "extended-projection: without sections of closed meshes with the planes");
  command.add_flag("!--no-improved", o.improved, "extended-projection: without the improved Projection of occludees");
}

std::map<std::string, std::string> text_of(extended_projection::Options const& o)
{
  std::string distances;
  for (double const d : o.distances) distances += (distances.empty() ? "" : ",") + std::to_string(d);
  std::string const directions = o.directions == extended_projection::Directions::cell   ? "cell"
                                 : o.directions == extended_projection::Directions::axes ? "axes"
                                                                                         : "automatic";
  std::map<std::string, std::string> out{
    {"resolution", std::to_string(o.resolution)},
    {"extent", std::to_string(o.extent)},
    {"occluders", std::to_string(o.occluders)},
    {"more-occluders", o.more_occluders ? "on" : "off"},
    {"kernel", std::to_string(o.kernel)},
    {"depth", o.depth == extended_projection::PartDepth::part ? "part" : "pixel"},
    {"slices", o.slices ? "on" : "off"},
    {"improved", o.improved ? "on" : "off"},
    {"directions", directions},
    {"infinity", o.infinity ? "on" : "off"},
    {"reprojection", o.reprojection == extended_projection::Reprojection::windows ? "windows" : "convolution"}};
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
  command.add_flag("--tally", tally,
                   "strong-occlusion, exact-2.5d, filtered: count in the statistics which layer decided each sign");
  command.add_option("--granularity", granularity,
                     "strong-occlusion, ray-space: object, part, face (default) or triangle");
  command.add_option("--coarse-granularity", coarse_granularity,
                     "strong-occlusion: the same for all but the smallest --cell-size (default part)");
  command.add_flag(
    "--no-inner-bodies", no_inner_bodies,
    "strong-occlusion, extended-projection, ray-space: do not look for convex occluders inside non-convex "
    "objects");
  command.add_option("--resolution", resolution,
                     "extended-projection, ray-space: pixels of a map along a side (default 256, ray-space 4096)");
  command.add_option("--components", components, "ray-space: umbrae kept in each pixel (default 2)");
  command.add_option("--coarse", coarse,
                     "ray-space: pixels that a map begins with along a side, halved where they must be (default 128)");
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
  if (tally && ((method != "strong-occlusion" && method != "exact-2.5d") || arithmetic != "filtered"))
    throw BadInput("--tally applies to the filtered arithmetic of strong-occlusion and exact-2.5d only");
  if (tally && !explain.empty()) throw BadInput("--tally and --explain are two runs: give one of them");
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
            {"coarse", std::to_string(ray_space_options(*this).first_resolution())},
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

}  // namespace visibility::commands
