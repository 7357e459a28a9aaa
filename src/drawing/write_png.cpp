#include "paint_picture.hpp"
#include "png_canvas.hpp"

namespace visibility {

std::string to_png(PlanPicture const& picture, PictureStyle const& style)
{
  auto const layout = detail::drawing::picture_layout(picture, style);
  detail::drawing::PngCanvas canvas(layout.width, layout.height);
  detail::drawing::paint(canvas, picture, layout, style);
  return canvas.finish();
}

}  // namespace visibility
