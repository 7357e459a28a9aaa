#pragma once

#include "cell_points.hpp"
#include "object_points.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace visibility::detail {

/// Ways to choose the next ray. Those after `horizontal` are guided by what was found.
enum class Strategy : std::uint8_t {
  uniform,     ///< any direction of the sphere
  horizontal,  ///< any azimuth, elevations on all scales: cities lie along the horizon
  unfound,     ///< at a face of an object not found yet
  neighbour,   ///< at a face of one near an object that was found
  silhouette,  ///< past an edge of an object that was found
  skyline,     ///< over a top edge of one
  mutation,    ///< a sight line that found something, shaken at some scale [Wonka06]
  critical,    ///< along a line that touches edges of two neighbours: slits
  reverse      ///< at an object not found yet, past an edge of what blocked an earlier try [Wonka06]
};
inline constexpr std::size_t strategies = 9;
inline constexpr std::array<std::string_view, strategies> strategy_names{
  "uniform", "horizontal", "unfound", "neighbour", "silhouette", "skyline", "mutation", "critical", "reverse"};

/// What the search has learned; const while a round of rays is planned and cast.
struct Knowledge {
  struct Sighting {
    std::uint32_t object;
    Point3d from, to;
  };
  struct Blocked {
    std::uint32_t wanted, blocker;
    Point3d from;
  };
  std::vector<std::uint32_t> found;    ///< in the order found; starts with what was known
  std::vector<std::uint32_t> unfound;  ///< may lag behind `wanted` by a few
  std::vector<std::uint8_t> wanted;    ///< per object: not found yet
  std::vector<Sighting> sightings;     ///< in the order found
  std::vector<Blocked> blocked;        ///< recent tries in vain
};

/// The next ray to cast. An aimed ray that gets as far as its aim proposes it, whatever stands there.
struct Plan {
  Point3d origin, direction;
  std::optional<Aim> aim;
};

/// Plans rays; const, so rounds may be planned in parallel.
class Planner {
public:
  Planner(PreparedScene const& scene, CellPoints const& cell, Knowledge const& knowledge)
    : scene_(scene), cell_(cell), objects_(scene), knowledge_(knowledge)
  {
  }
  Plan plan(Random& random, Strategy strategy) const;

private:
  Plan horizontal(Random& random) const;
  Plan past_edge(Random& random, bool upper) const;
  Plan mutated(Random& random) const;
  Plan critical(Random& random) const;
  Plan reversed(Random& random) const;
  Plan at(Random& random, std::uint32_t object) const;

  std::uint32_t some_found(Random& random) const;
  std::uint32_t some_unfound(Random& random) const;
  /// An object near the given one; of those not found yet if `wanted`.
  std::optional<std::uint32_t> neighbour(Random& random, std::uint32_t object, bool wanted) const;
  double apparent_size(std::uint32_t object) const;

  PreparedScene const& scene_;
  CellPoints const& cell_;
  ObjectPoints objects_;
  Knowledge const& knowledge_;
};

}  // namespace visibility::detail
