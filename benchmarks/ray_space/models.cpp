#include "experiments.hpp"

#include "visibility/methods/sampling/method.hpp"
#include "visibility/scene/generators.hpp"

namespace visibility::bench::ray_space {

Model::Model(std::string const& specification, bool with_rays) : scene(generate(specification))
{
  build_seconds = median_seconds<ProcessorClock>(
    1, 0, [&] { prepared = std::make_unique<PreparedScene>(scene, InnerBodyOptions{}); });
  if (with_rays) rays = std::make_unique<RayScene>(*prepared);
}

Measured measure(PreparedScene const& scene, ViewCell const& cell, Options const& options, bool triangles)
{
  Measured m;
  RaySpace const method(options);
  m.seconds =
    median_seconds<ProcessorClock>(3, 5, [&] { m.objects = static_cast<double>(method(scene, cell).visible.size()); });
  if (triangles) m.triangles = static_cast<double>(method.triangles(scene, cell).second.size());
  return m;
}

Measured measure_once(PreparedScene const& scene, ViewCell const& cell, Options const& options)
{
  Measured m;
  m.seconds = median_seconds<ProcessorClock>(
    1, 0, [&] { m.objects = static_cast<double>(RaySpace(options)(scene, cell).visible.size()); });
  return m;
}

double sampled(Model const& model, ViewCell const& cell, Size size)
{
  Sampling::Options options;
  options.rays = size == Size::full ? 3'000'000 : 10'000;
  return static_cast<double>(Sampling(options)(*model.rays, cell).visible.size());
}

ViewCell cell_at(double x, double y, double side, double height)
{
  return ViewCell(Box{{x - side / 2, y - side / 2, 0}, {x + side / 2, y + side / 2, height}});
}

}  // namespace visibility::bench::ray_space
