#include "visibility/line_space/cell_outline.hpp"

#include "visibility/predicates/orient2d.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace visibility {

CellOutline::CellOutline(ViewCell const& cell)
{
  auto const& shape = cell.shape();
  auto const& v = shape.vertices;
  auto const is_upper = [&](ConvexPolyhedron::Facet const& f) {
    return is_positive(
      orient2d<Filtered>(horizontal(v[f.vertices[0]]), horizontal(v[f.vertices[1]]), horizontal(v[f.vertices[2]])));
  };
  // Each edge of the hull is met once in either direction; the outline has an upper facet on one side only.
  std::vector<int> upper_facets(shape.edges.size(), 0);
  std::vector<std::array<std::uint32_t, 2>> apexes(shape.edges.size());
  std::map<std::uint32_t, std::uint32_t> next;
  for (auto const& f : shape.facets) {
    if (!is_upper(f)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      auto const e = static_cast<std::size_t>(f.edges[i] < 0 ? ~f.edges[i] : f.edges[i]);
      apexes[e][static_cast<std::size_t>(upper_facets[e]++)] = f.vertices[(i + 2) % 3];
    }
  }
  for (auto const& f : shape.facets) {
    if (!is_upper(f)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      auto const e = static_cast<std::size_t>(f.edges[i] < 0 ? ~f.edges[i] : f.edges[i]);
      if (upper_facets[e] == 1) next[f.vertices[i]] = f.vertices[(i + 1) % 3];
    }
  }
  for (std::size_t e = 0; e < shape.edges.size(); ++e) {
    if (upper_facets[e] != 2) continue;
    Point3d const &a = v[shape.edges[e].from], &b = v[shape.edges[e].to];
    if (!is_zero(orient3d<Filtered>(a, b, v[apexes[e][0]], v[apexes[e][1]]))) inner.push_back({a, b});
  }
  auto const start = next.begin()->first;
  auto at = start;
  do {
    corners.push_back(v[at]);
    at = next.at(at);
  } while (at != start);

  Box const& b = cell.bounds();
  top = b.max.z;
  bottom = b.min.z;
  flat = std::ranges::all_of(corners, [&](Point3d const& c) { return c.z == top; });
  centre = {b.min.x / 2 + b.max.x / 2, b.min.y / 2 + b.max.y / 2};
  for (auto const& c : corners) radius = std::max(radius, std::hypot(c.x - centre.x, c.y - centre.y));
  radius *= 1 + 0x1p-40;
}

}  // namespace visibility
