#include "mesh.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <vector>

namespace visibility::generators {

void add_prism(SceneBuilder& scene, std::span<Point2d const> footprint, double bottom, double top)
{
  auto const m = static_cast<std::uint32_t>(footprint.size());
  std::uint32_t low = 0;
  for (std::uint32_t i = 0; i < m; ++i) {
    auto const v = scene.add_vertex({footprint[i].x, footprint[i].y, bottom});
    if (i == 0) low = v;
  }
  for (auto const& p : footprint) scene.add_vertex({p.x, p.y, top});
  std::uint32_t const high = low + m;
  for (std::uint32_t i = 0; i < m; ++i) {
    std::uint32_t const j = (i + 1) % m;
    scene.add_triangle(low + i, low + j, high + j);
    scene.add_triangle(low + i, high + j, high + i);
  }
  for (std::uint32_t i = 2; i < m; ++i) {
    scene.add_triangle(low, low + i, low + i - 1);
    scene.add_triangle(high, high + i - 1, high + i);
  }
}

void add_convex_quad(SceneBuilder& scene, std::array<std::uint32_t, 4> const& v, std::array<Point3d, 4> const& p)
{
  // Facets see inner points on their negative side: if d is not beyond a, b, c, the diagonal a-c bulges or is flat.
  if (is_positive(orient3d<Filtered>(p[0], p[1], p[2], p[3]))) {
    scene.add_triangle(v[0], v[1], v[3]);
    scene.add_triangle(v[1], v[2], v[3]);
  } else {
    scene.add_triangle(v[0], v[1], v[2]);
    scene.add_triangle(v[0], v[2], v[3]);
  }
}

void add_hexahedron(SceneBuilder& scene, std::array<Point3d, 8> const& corners)
{
  static constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    auto const v = scene.add_vertex(corners[i]);
    if (i == 0) first = v;
  }
  for (auto const& [a, b, c, d] : faces)
    add_convex_quad(scene, {first + a, first + b, first + c, first + d},
                    {corners[a], corners[b], corners[c], corners[d]});
}

}  // namespace visibility::generators
