#pragma once

#include "visibility/scene/scene.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace visibility {

/// One parameter of a generator: `name=value` in a specification.
struct GeneratorParameter {
  enum class Type { integer, number };
  std::string name;
  Type type;
  double value;      ///< the default
  double min, max;   ///< closed range of valid values; integers lie within +-2^53, where every one is a double
  std::string help;  ///< one line, with units
};

/// One kind of scene that `generate` makes.
struct GeneratorKind {
  std::string name;
  std::string help;       ///< one line: what it is and which paper describes it
  std::string published;  ///< the specification that reproduces the size of the scene in the paper
  std::vector<GeneratorParameter> parameters;
};

/// All kinds, in the order in which they are to be shown.
std::span<GeneratorKind const> generator_kinds();

/// The scene of a specification `KIND` or `KIND,key=value,...` (what follows `gen:` on the command line).
///
/// The same specification gives the same scene, bit for bit, on every machine whose doubles are IEEE 754: random bits
/// come from integer arithmetic and coordinates from + - * / and sqrt alone. Objects draw from streams of their own,
/// so that a longer scene of the same seed starts with the objects of the shorter one, unless its kind says otherwise.
/// Lengths are metres (in the papers, "units"); every scene lies in z >= 0 except the circles, whose plane is z = 0.
/// Throws BadInput, with one line that lists what is valid, for an unknown kind or key, a repeated key, or a value
/// that is no number, out of range or impossible together with the others.
Scene generate(std::string_view specification);

}  // namespace visibility
