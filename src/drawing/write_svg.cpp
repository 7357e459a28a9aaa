#include "paint_picture.hpp"
#include "svg_canvas.hpp"

namespace visibility {

std::string to_svg(PlanPicture const& picture, PictureStyle const& style)
{
  auto const layout = detail::drawing::picture_layout(picture, style);
  detail::drawing::SvgCanvas canvas(layout.width, layout.height, picture.title);
  detail::drawing::paint(canvas, picture, layout, style);
  return canvas.finish();
}

}  // namespace visibility
