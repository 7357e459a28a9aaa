#pragma once

#include "canvas.hpp"

#include "visibility/drawing/write_picture.hpp"

#include <string>
#include <vector>

namespace visibility::detail::drawing {

/// A sample of how something is drawn, and what it is.
struct LegendEntry {
  enum class Sample : std::uint8_t { area, line, cased_line, sight_line };
  Sample sample;
  Paint paint;
  std::string text;
  Point2d at{};  ///< upper left corner of the sample
};

/// Where everything goes: title, the framed plan, and below it the scale and the legend, in columns. Nothing overlaps.
struct PictureLayout {
  int width, height;
  Point2d title, subtitle;  ///< starts of baselines
  Rectangle frame;
  std::vector<LegendEntry> legend;
  Point2d scale_bar;  ///< left end
  double scale_metres, scale_pixels;
};

inline constexpr double sample_width = 24, sample_height = 12;
inline constexpr TextStyle title_style{17, true}, text_style{13};

/// Throws std::invalid_argument unless 200 <= style.size <= 20000.
PictureLayout picture_layout(PlanPicture const& picture, PictureStyle const& style);

}  // namespace visibility::detail::drawing
