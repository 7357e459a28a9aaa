#include "visibility/drawing/write_picture.hpp"
#include "visibility/scene/scene_builder.hpp"

namespace visibility {

std::string to_png(PlanPicture const&, PictureStyle const&)
{
  throw BadInput("this program was built without cairo and cannot write PNG; write .svg");
}

}  // namespace visibility
