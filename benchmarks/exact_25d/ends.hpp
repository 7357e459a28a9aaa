#pragma once

#include "scenes.hpp"

#include "visibility/kernel/arithmetic.hpp"

namespace visibility::bench::exact_25d {

/// Whether the method comes to an end within `seconds` of processor time. Tried in a process of its own.
template <Arithmetic A>
bool ends(HeightField const&, ViewCell const&, unsigned seconds);

extern template bool ends<Filtered>(HeightField const&, ViewCell const&, unsigned);
extern template bool ends<Double>(HeightField const&, ViewCell const&, unsigned);

/// Those of free_cells() that the exact method answers within 5 s; the others become a note.
std::vector<ViewCell> answered_cells(Model const&, CellShape const&, int count, std::vector<std::string>& notes);

}  // namespace visibility::bench::exact_25d
