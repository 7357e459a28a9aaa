#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace visibility::strong_occlusion {

/// How finely an object is looked at before it is called potentially visible: each level is tried where the one before
/// it found no strong occluder, so a finer granularity never gives a larger set.
enum class Granularity {
  object,   ///< its bounding box, as a whole
  part,     ///< each convex body (box, prism piece, polyhedron, triangle)
  face,     ///< each face that looks towards the cell
  triangle  ///< each triangle of such a face
};

inline std::string to_string(Granularity g)
{
  switch (g) {
  case Granularity::object: return "object";
  case Granularity::part: return "part";
  case Granularity::face: return "face";
  case Granularity::triangle: return "triangle";
  }
  return {};
}

/// Throws std::invalid_argument.
inline Granularity granularity_from_string(std::string const& name)
{
  for (auto const g : {Granularity::object, Granularity::part, Granularity::face, Granularity::triangle})
    if (to_string(g) == name) return g;
  throw std::invalid_argument("unknown granularity '" + name + "' (object, part, face or triangle)");
}

/// The switches are the optimizations of [CohenOr98, 5], by their numbers there, and two of our own; the paper's sixth,
/// refinement of cells, is viewspace/. All save work only: the set is the same with any of them on or off.
/// What each is worth: docs/strong-occlusion.md.
struct Options {
  Granularity granularity = Granularity::face;
  /// 1: candidates one at a time, nearest first. Off: every ray lists all bodies it meets, and the lists are
  /// intersected.
  bool leading_ray = true;
  /// 2: a body that is hidden itself is no candidate; whatever it hides is hidden by what hides it.
  bool skip_hidden = true;
  /// 3: only sight lines along edges of the convex hull of cell and target, where they suffice.
  bool hull_rays = true;
  /// 4: whole groups of the object hierarchy are tested first, and dropped if they have a strong occluder.
  bool groups = true;
  /// 5: occluders found last are tried first. For groups they are the only ones tried.
  bool cache = true;
  /// Visible objects first: one sight line is cast through all occluders before any is sought, and one face is looked
  /// at before the whole; if the line is free, or the face has no strong occluder, the object is visible. The paper
  /// weighs the former and drops it, having few visible objects.
  bool visible_first = true;
  /// Candidates are sought only where all sight lines pass, in place of along the leading ray.
  bool shaft = true;

  /// The algorithm of [CohenOr98, 3]: no optimization at all.
  static Options naive(Granularity granularity)
  {
    return {granularity, false, false, false, false, false, false, false};
  }
};

/// The switches by name.
inline constexpr std::array<std::pair<std::string_view, bool Options::*>, 7> optimizations{{
  {"leading-ray", &Options::leading_ray},
  {"skip-hidden", &Options::skip_hidden},
  {"hull-rays", &Options::hull_rays},
  {"groups", &Options::groups},
  {"cache", &Options::cache},
  {"visible-first", &Options::visible_first},
  {"shaft", &Options::shaft},
}};

}  // namespace visibility::strong_occlusion
