#pragma once

#include "canvas.hpp"

#include "visibility/drawing/plan_picture.hpp"

/// Colours of Okabe and Ito (2008), which most colour-blind people tell apart; things that may lie side by side differ
/// in lightness or hatching too, for prints without colour.
namespace visibility::detail::drawing::palette {

inline constexpr Colour black{0, 0, 0}, orange{0xE6, 0x9F, 0x00}, sky_blue{0x56, 0xB4, 0xE9}, green{0x00, 0x9E, 0x73},
  yellow{0xF0, 0xE4, 0x42}, blue{0x00, 0x72, 0xB2}, vermillion{0xD5, 0x5E, 0x00}, purple{0xCC, 0x79, 0xA7};
inline constexpr Colour white{255, 255, 255}, light_grey{0xDE, 0xDE, 0xDE}, grey{0xB0, 0xB0, 0xB0},
  dark_grey{0x60, 0x60, 0x60};

inline Paint paint_of(PlanRole role)
{
  switch (role) {
  case PlanRole::occluder: return {Fill{white, Hatch::dots, grey}, Stroke{grey, 0.6}};
  case PlanRole::hidden: return {Fill{light_grey}, Stroke{grey, 0.5}};
  case PlanRole::visible: return {Fill{blue}, Stroke{{0x00, 0x33, 0x55}, 0.7}};
  case PlanRole::touching: return {Fill{orange, Hatch::dots, black}, Stroke{black, 0.8}};
  case PlanRole::only_first: return {Fill{vermillion, Hatch::rising, white}, Stroke{{0x60, 0x28, 0x00}, 0.7}};
  case PlanRole::only_second: break;
  }
  return {Fill{green, Hatch::falling, black}, Stroke{{0x00, 0x40, 0x30}, 0.7}};
}

inline constexpr Fill cell_fill{yellow};
inline constexpr Stroke cell_outline{black, 2};
inline constexpr Stroke sight_line{black, 0.8, 0, 0.75};
inline constexpr Fill sight_line_end{white};
inline constexpr Stroke edge_casing{black, 4};
inline constexpr Stroke seen_wall{yellow, 2.4};
inline constexpr Stroke seen_top{sky_blue, 2.4, 4};
inline constexpr Fill funnel_area{purple, Hatch::none, white, 0.3};
inline constexpr Stroke funnel_line{{0x88, 0x33, 0x66}, 0.8};
inline constexpr Fill shadow_area{black, Hatch::none, white, 0.16};
inline constexpr Stroke shadow_outline{black, 0.7, 3};

}  // namespace visibility::detail::drawing::palette
