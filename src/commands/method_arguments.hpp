#pragma once

#include "visibility/methods/extended_projection/options.hpp"
#include "visibility/methods/ray_space/options.hpp"
#include "visibility/methods/strong_occlusion/options.hpp"
#include "visibility/scene/scene.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace visibility::commands {

/// Which method is to run, with what arithmetic and options: the part of the command line that `pvs` has beside the
/// scene and the cells.
struct MethodArguments {
  std::string method = "strong-occlusion";
  std::string arithmetic = "filtered";
  bool tally = false;  ///< count which layer of the filtered arithmetic decided each sign
  std::string granularity = "face";
  std::string coarse_granularity = "part";
  bool no_inner_bodies = false;
  std::optional<int> resolution;  ///< of maps; the method's default
  int components = 2;
  int coarse = ray_space::Options{}.coarse;
  std::string umbra = "full", bounds = "exact";
  bool witnesses = false;
  std::string occludees;                    ///< scene that is looked for; empty: the scene itself
  std::string explain;                      ///< file for visible parts, funnels and shadow planes; empty: none
  extended_projection::Options projection;  ///< of extended-projection and occlusion-sweep
  std::vector<std::string> without;         ///< optimizations of strong occlusion that are switched off
  std::uint64_t rays = 1'000'000;
  double seconds = 0;
  std::uint64_t seed = 1;

  void add_to(CLI::App& command);
  /// Throws BadInput for a method, arithmetic or option value that does not exist.
  void validate() const;
  /// The options that matter to the method, as text for the result file.
  std::map<std::string, std::string> options() const;
};

std::vector<std::string> method_names();

/// The options of a method as the arguments have them. Requires: validated arguments.
strong_occlusion::Options strong_occlusion_options(MethodArguments const&);
extended_projection::Options projection_options(MethodArguments const&);
/// Whether the method asks for sections of meshes.
bool uses_slices(MethodArguments const& arguments);
ray_space::Options ray_space_options(MethodArguments const&);

}  // namespace visibility::commands
