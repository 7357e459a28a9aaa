#include "visibility/scene/scene_report.hpp"

#include "visibility/geometry/segment_coplanar.hpp"

#include <algorithm>

namespace visibility {

namespace {

/// Number of triangles that repeat an earlier one, compared by coordinates, whatever the order of the vertices.
std::size_t count_duplicates(Scene const& scene)
{
  using Key = std::array<std::uint32_t, 3>;
  // Equal coordinates get equal numbers, so that triangles compare as integers.
  std::vector<std::uint32_t> order(scene.vertices.size()), number(scene.vertices.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  auto const& v = scene.vertices;
  std::ranges::sort(order, [&](auto a, auto b) { return detail::lexicographically_less(v[a], v[b]); });
  for (std::size_t i = 0; i < order.size(); ++i)
    number[order[i]] = i > 0 && v[order[i]] == v[order[i - 1]] ? number[order[i - 1]] : static_cast<std::uint32_t>(i);
  std::vector<Key> keys;
  keys.reserve(scene.triangles.size());
  for (auto const& t : scene.triangles) {
    Key k{number[t[0]], number[t[1]], number[t[2]]};
    std::ranges::sort(k);
    keys.push_back(k);
  }
  std::ranges::sort(keys);
  return keys.size() - static_cast<std::size_t>(std::unique(keys.begin(), keys.end()) - keys.begin());
}

}  // namespace

SceneReport report(Scene const& scene)
{
  SceneReport r;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    auto const [a, b, c] = scene.triangle(i).vertices;
    r.zero_area_triangles += detail::projection_axis<Filtered>(a, b, c) < 0;
  }
  r.duplicate_faces = count_duplicates(scene);
  r.flat_boxes =
    static_cast<std::size_t>(std::ranges::count_if(scene.boxes, [](Box const& b) { return !b.has_interior(); }));
  return r;
}

}  // namespace visibility
