#pragma once

#include "visibility/scene/height_field.hpp"
#include "visibility/scene/view_cell.hpp"

namespace visibility::bench::exact_25d {

/// Whether the method with plain double comes to an end, within `seconds` of processor time: rounding may send it in
/// circles. Tried in a process of its own.
bool double_ends(HeightField const&, ViewCell const&, unsigned seconds);

}  // namespace visibility::bench::exact_25d
