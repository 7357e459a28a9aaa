#include "visibility/methods/ray_space/method.hpp"

#include "visibility/methods/ray_space/search.hpp"

#include <numeric>

namespace visibility {

namespace {

PotentiallyVisibleSet make_set(std::vector<std::uint32_t> visible, ray_space::Counts const& c)
{
  PotentiallyVisibleSet set;
  set.guarantee = Guarantee::conservative;
  set.visible = std::move(visible);
  set.statistics = {{"nodes", double(c.nodes)},   {"objects", double(c.objects)},
                    {"parts", double(c.parts)},   {"occluders", double(c.occluders)},
                    {"pixels", double(c.pixels)}, {"parts_of_pixels", double(c.parts_of_pixels)}};
  return set;
}

/// The answer that is right from any cell, for cells whose numbers are out of all proportion.
std::vector<std::uint32_t> all(std::size_t n)
{
  std::vector<std::uint32_t> out(n);
  std::iota(out.begin(), out.end(), 0U);
  return out;
}

}  // namespace

PotentiallyVisibleSet RaySpace::operator()(PreparedScene const& scene, ViewCell const& cell) const
{
  if (!ray_space::Frame::in_domain(cell.bounds())) return make_set(all(scene.scene().objects.size()), {});
  ray_space::Search search(scene, cell, options_);
  auto visible = search.run();
  return make_set(std::move(visible), search.counts());
}

std::pair<PotentiallyVisibleSet, std::vector<std::uint32_t>> RaySpace::triangles(PreparedScene const& scene,
                                                                                 ViewCell const& cell) const
{
  if (!ray_space::Frame::in_domain(cell.bounds()))
    return {make_set(all(scene.scene().objects.size()), {}), all(scene.scene().triangles.size())};
  ray_space::Search search(scene, cell, options_);
  auto visible = search.run();
  auto triangles = search.triangles_of(visible);
  return {make_set(std::move(visible), search.counts()), std::move(triangles)};
}

}  // namespace visibility
