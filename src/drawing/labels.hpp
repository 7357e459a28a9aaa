#pragma once

#include "picture_layout.hpp"
#include "pixel_path.hpp"

#include <vector>

namespace visibility::detail::drawing {

struct Label {
  Point2d at;  ///< middle of the baseline
  std::string text;
};
inline constexpr TextStyle label_style{11, false, true, true};

/// Names of the visible objects, and of the hidden ones where none is in the way: larger objects first, each in the
/// middle of its object, or above a small one; a label that would cover another or leave the frame is left out.
std::vector<Label> place_labels(PlanPicture const& picture, PixelMap const& map, PictureLabels wanted);

}  // namespace visibility::detail::drawing
