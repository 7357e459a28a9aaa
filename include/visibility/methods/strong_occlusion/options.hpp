#pragma once

#include <stdexcept>
#include <string>

namespace visibility::strong_occlusion {

/// How finely an object is looked at before it is called potentially visible: each level is tried where the one before
/// it found no strong occluder, so a finer granularity never gives a larger set.
enum class Granularity {
  object,  ///< its bounding box, as a whole
  part,    ///< each convex body (box, prism piece, polyhedron, triangle)
  face     ///< each face that looks towards the cell
};

inline std::string to_string(Granularity g)
{
  return g == Granularity::object ? "object" : g == Granularity::part ? "part" : "face";
}

/// Throws std::invalid_argument.
inline Granularity granularity_from_string(std::string const& name)
{
  for (auto const g : {Granularity::object, Granularity::part, Granularity::face})
    if (to_string(g) == name) return g;
  throw std::invalid_argument("unknown granularity '" + name + "' (object, part or face)");
}

struct Options {
  Granularity granularity = Granularity::face;
  /// Test the boxes of whole groups first and drop a group that has a strong occluder [Cohen-Or98, 5, optimization 4].
  /// Saves work, never changes the set.
  bool groups = true;
};

}  // namespace visibility::strong_occlusion
