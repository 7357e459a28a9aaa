#pragma once

#include "visibility/kernel/point.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace visibility {

/// What a result promises about the set of visible objects.
enum class Guarantee {
  exact,         ///< the set, no more, no less
  conservative,  ///< a superset: nothing visible is missing
  aggressive,    ///< a subset: nothing hidden is listed
  none           ///< plain floating point
};
std::string to_string(Guarantee guarantee);
Guarantee guarantee_from_string(std::string const& name);  ///< throws std::invalid_argument

/// Proof that an object is visible: the segment from `from`, in the cell's interior, to `to`, in the relative interior
/// of a face of the object, meets no occluder before `to`.
struct Witness {
  std::uint32_t object;
  Point3q from, to;
};

/// The answer of a method for one cell.
struct PotentiallyVisibleSet {
  Guarantee guarantee = Guarantee::none;
  std::vector<std::uint32_t> visible;        ///< indices of objects, ascending
  std::map<std::string, double> statistics;  ///< counts and sizes of the run, no times
  std::vector<Witness> witnesses;            ///< of methods that produce them, by ascending object
};

}  // namespace visibility
