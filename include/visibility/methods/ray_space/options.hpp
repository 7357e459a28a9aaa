#pragma once

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

/// What is looked at before an object is called potentially visible; a finer one never gives a larger set.
enum class Granularity {
  object,   ///< its bounding box
  body,     ///< each of its convex bodies
  triangle  ///< each triangle of a mesh that is not one convex solid; other bodies as above
};

inline std::string to_string(Umbra u) { return u == Umbra::half ? "half" : "full"; }
inline std::string to_string(Bounds b) { return b == Bounds::exact ? "exact" : "linear"; }

struct Options {
  /// Side of the whole map: it has resolution^2 / 2 pixels, a quarter of them for each family of directions. Sizes that
  /// are no multiple of 8 are rounded down. [Leyvand03, table 4]
  int resolution = 512;
  int components = 2;  ///< umbrae kept for each pixel, at least 1
  Umbra umbra = Umbra::full;
  Bounds bounds = Bounds::exact;
  Granularity granularity = Granularity::body;

  static constexpr int min_resolution = 8, max_resolution = 8192, max_components = 16;

  /// Throws std::invalid_argument unless the numbers are in their ranges.
  void validate() const
  {
    if (resolution < min_resolution || resolution > max_resolution)
      throw std::invalid_argument("ray-space: the resolution must be from 8 to 8192");
    if (components < 1 || components > max_components)
      throw std::invalid_argument("ray-space: the number of components must be from 1 to 16");
  }
};

}  // namespace visibility::ray_space
