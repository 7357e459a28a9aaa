#include "experiments.hpp"

namespace visibility::bench::strong_occlusion {

std::string city(Size size) { return size == Size::full ? "city" : "city,n=200"; }

ViewCell ground_cell(double side, double x, double y)
{
  double const h = side / 2;
  return ViewCell(Box{{x - h, y - h, 0}, {x + h, y + h, 50}});
}

Options as_published()
{
  Options o = Options::naive(Options{}.granularity);
  o.leading_ray = true;
  return o;
}

}  // namespace visibility::bench::strong_occlusion
