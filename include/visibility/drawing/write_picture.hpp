#pragma once

#include "visibility/drawing/plan_picture.hpp"

#include <string>

namespace visibility {

enum class PictureLabels { automatic, off, on };

struct PictureStyle {
  int size = 1000;  ///< width in pixels, 200 to 20000; the height follows from the region and the legend
  PictureLabels labels = PictureLabels::automatic;  ///< names of objects, where they fit; automatic: of up to 40
};

/// The picture with title, legend with counts and scale bar. The same picture gives the same bytes. Colours are those
/// of Okabe and Ito, and differ in lightness or hatching too. In both formats crowds are drawn as a few paths, with
/// what is smaller than a pixel merged. SVG: text stays text, each object of a small crowd has its name as a tooltip;
/// needs no library.
std::string to_svg(PlanPicture const& picture, PictureStyle const& style = {});
/// PNG bytes, through cairo. Throws BadInput if the library was built without it, or if it fails.
std::string to_png(PlanPicture const& picture, PictureStyle const& style = {});

}  // namespace visibility
