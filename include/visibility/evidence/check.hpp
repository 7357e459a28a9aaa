#pragma once

#include "visibility/evidence/ray_scene.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace visibility {

struct CheckOptions {
  std::uint64_t rays = 10'000'000;
  double seconds = 0;  ///< wall-clock limit; 0: none
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all. Without a time limit the report does not depend on it
  std::function<void(std::uint64_t rays)> progress{};  ///< told how many rays have been cast since it was last told
};

struct CheckReport {
  std::vector<std::uint32_t> missing;  ///< visible objects that the set lacks, ascending; each is proved
  std::vector<Witness> witnesses;      ///< of those that do not meet the closed cell, by ascending object
  std::vector<std::uint32_t> unseen;   ///< members that no ray hit: information, no fault; empty unless claimed exact
  std::uint64_t rays = 0;
  std::uint64_t objects_seen = 0;  ///< distinct objects that single-precision rays hit, members or not; no lower bound
  std::uint64_t rejected = 0;      ///< proposed sight lines to non-members that the exact predicate refused
  double seconds = 0;

  /// A superset is claimed, and something is missing. An aggressive set may lack anything.
  bool fault = false;
};

/// Hunts for visible objects that the set lacks, with guided rays; each find is proved by an exact witness before it is
/// reported, unless it meets the closed cell. Finding nothing proves nothing. Returns at once if nothing is left to
/// find. Throws std::invalid_argument if `visible` names an object that the scene does not have.
CheckReport check(RayScene const& rays, ViewCell const& cell, std::span<std::uint32_t const> visible, Guarantee claimed,
                  CheckOptions const& options = {});
CheckReport check(PreparedScene const& scene, ViewCell const& cell, std::span<std::uint32_t const> visible,
                  Guarantee claimed, CheckOptions const& options = {});

}  // namespace visibility
