#pragma once

#include "picture_layout.hpp"

namespace visibility::detail::drawing {

/// Paints the whole picture: the same for every format.
void paint(Canvas& canvas, PlanPicture const& picture, PictureLayout const& layout, PictureStyle const& style);

}  // namespace visibility::detail::drawing
