#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

namespace visibility::ray_space {

/// Which occlusion is kept in a vertical slice. [Leyvand03, section 5]
enum class Umbra {
  half,  ///< only of occluders that no sight line passes below: 2.5D
  full   ///< of all, bounded from below as well
};

/// How the extremes of a slice over a pixel are bounded.
enum class Bounds {
  exact,  ///< the rational functions of (s, t) at the corners of the pixel, where they are extreme
  linear  ///< the paper's approximation: distance or height replaced by a constant, the other by a plane
};

/// How finely an object is looked at before it is called potentially visible: each level is tried where the one before
/// it found something visible, so a finer granularity never gives a larger set.
enum class Granularity {
  object,   ///< its bounding box, as a whole
  part,     ///< each convex body
  face,     ///< each face of one that looks towards the cell
  triangle  ///< each triangle of such a face
};

inline std::string to_string(Umbra u) { return u == Umbra::half ? "half" : "full"; }
inline std::string to_string(Granularity g)
{
  constexpr char const* names[] = {"object", "part", "face", "triangle"};
  return names[static_cast<int>(g)];
}
/// Throws std::invalid_argument.
inline Granularity granularity_from_string(std::string const& name)
{
  for (auto const g : {Granularity::object, Granularity::part, Granularity::face, Granularity::triangle})
    if (to_string(g) == name) return g;
  throw std::invalid_argument("unknown granularity '" + name + "' (object, part, face or triangle)");
}
inline std::string to_string(Bounds b) { return b == Bounds::exact ? "exact" : "linear"; }

struct Options {
  /// Side of the whole map in its finest pixels: resolution^2 / 2 of them cover it, a quarter for each family of
  /// directions. [Leyvand03, table 4]
  int resolution = 4096;
  /// The same in the pixels that the map begins with. They are halved, either way, where something would else be
  /// visible, as often as the resolution is twice as high; no more than the resolution counts. Sizes that are no
  /// multiple of 8 are rounded down.
  int coarse = 128;
  int components = 2;  ///< umbrae kept for each pixel, at least 1
  Umbra umbra = Umbra::full;
  Bounds bounds = Bounds::exact;
  Granularity granularity = Granularity::face;

  static constexpr int min_resolution = 8, max_resolution = 65536, max_coarse = 4096, max_components = 16;

  /// Of the pixels that the map begins with.
  int first_resolution() const { return std::min(coarse, resolution); }
  /// How often these may be halved either way.
  int halvings() const
  {
    int n = 0;
    while (first_resolution() <= resolution >> (n + 1)) ++n;
    return n;
  }

  /// Throws std::invalid_argument unless the numbers are in their ranges.
  void validate() const
  {
    if (resolution < min_resolution || resolution > max_resolution)
      throw std::invalid_argument("ray-space: the resolution must be from 8 to 65536");
    if (coarse < min_resolution || coarse > max_coarse)
      throw std::invalid_argument("ray-space: the coarse resolution must be from 8 to 4096");
    if (components < 1 || components > max_components)
      throw std::invalid_argument("ray-space: the number of components must be from 1 to 16");
  }
};

}  // namespace visibility::ray_space
