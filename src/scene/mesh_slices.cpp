#include "mesh_slices.hpp"

#include <algorithm>
#include <limits>

namespace visibility::detail {

namespace {

using Index = std::uint32_t;
constexpr Index none = -1;

/// Where an edge of a facet crosses the height. Ends come in pairs: 2f and 2f + 1 belong to facet number f of the
/// slice.
struct Crossing {
  Index below, above, end;
};

std::vector<Crossing> crossings(MeshShell const& shell, double z)
{
  std::vector<Crossing> out;
  Index end = 0;
  for (auto const& f : shell.facets)
    for (std::size_t i = 0; i < 3; ++i) {
      Index const a = f[i], b = f[(i + 1) % 3];
      bool const up = shell.vertices[a].z < z;
      if (up != (shell.vertices[b].z < z)) out.push_back({up ? a : b, up ? b : a, end++});
    }
  return out;
}

Point2d point_at(MeshShell const& shell, Crossing const& c, double z)
{
  Point3d const &a = shell.vertices[c.below], &b = shell.vertices[c.above];
  double const t = (z - a.z) / (b.z - a.z);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// Links each end to another: on the same edge if there is one, else to the nearest end left over.
std::vector<Index> linked(std::vector<Crossing> sorted, std::vector<Point2d> const& points)
{
  std::ranges::sort(sorted, {}, [](Crossing const& c) { return std::tuple(c.below, c.above, c.end); });
  std::vector<Index> partner(sorted.size(), none), open;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (i + 1 < sorted.size() && sorted[i].below == sorted[i + 1].below && sorted[i].above == sorted[i + 1].above) {
      partner[sorted[i].end] = sorted[i + 1].end;
      partner[sorted[i + 1].end] = sorted[i].end;
      ++i;
    } else {
      open.push_back(sorted[i].end);
    }
  while (open.size() > 1) {
    Index const e = open.back();
    open.pop_back();
    auto const nearest =
      std::ranges::min_element(open, {}, [&](Index other) { return plan::distance(points[e], points[other]); });
    partner[e] = *nearest;
    partner[*nearest] = e;
    open.erase(nearest);
  }
  return partner;
}

bool is_inside(plan::Polygon const& ring, Point2d const& p)
{
  bool odd = false;
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    Point2d const &a = ring[i], &b = ring[(i + 1) % n];
    if ((a.y > p.y) != (b.y > p.y)) odd ^= (plan::turn(a, b, p) > 0) == (b.y > a.y);
  }
  return odd;
}

/// Whether most corners of `inner` are inside `outer`: rings may touch.
bool is_inside(plan::Polygon const& outer, plan::Polygon const& inner)
{
  auto const n = std::ranges::count_if(inner, [&](Point2d const& p) { return is_inside(outer, p); });
  return 2 * static_cast<std::size_t>(n) > inner.size();
}

}  // namespace

std::vector<double> slice_heights(MeshShell const& shell, std::size_t most)
{
  std::vector<double> z{std::max(shell.floor, shell.bounds.min.z)};
  for (auto const& v : shell.vertices)
    if (v.z > z.front()) z.push_back(v.z);
  std::ranges::sort(z);
  z.erase(std::unique(z.begin(), z.end()), z.end());
  std::vector<std::pair<double, double>> gaps;  // size, middle
  for (std::size_t i = 1; i < z.size(); ++i) {
    double const middle = z[i - 1] + (z[i] - z[i - 1]) / 2;
    if (z[i - 1] < middle && middle < z[i]) gaps.emplace_back(z[i] - z[i - 1], middle);
  }
  std::ranges::sort(gaps, std::greater<>{});
  if (gaps.size() > most) gaps.resize(most);
  std::vector<double> heights;
  for (auto const& [size, middle] : gaps) heights.push_back(middle);
  std::ranges::sort(heights);
  return heights;
}

std::vector<plan::Polygon> slice(MeshShell const& shell, double z, double slack)
{
  auto const ends = crossings(shell, z);
  std::vector<Point2d> points;
  for (auto const& c : ends) points.push_back(point_at(shell, c, z));
  auto const partner = linked(ends, points);
  std::vector<plan::Polygon> rings;
  std::vector<bool> seen(ends.size());
  for (Index start = 0; start < ends.size(); ++start) {
    plan::Polygon ring;
    for (Index e = start; e != none && !seen[e]; e = partner[e ^ 1]) {
      seen[e] = seen[e ^ 1] = true;
      ring.push_back(points[e]);
    }
    ring = plan::without_straight_corners(ring, slack);
    if (ring.size() >= 3 && std::abs(plan::area(ring)) > slack * plan::perimeter(ring))
      rings.push_back(std::move(ring));
  }
  return rings;
}

std::vector<std::vector<plan::Polygon>> nested(std::vector<plan::Polygon> rings)
{
  std::ranges::sort(rings, std::greater<>{}, [](auto const& r) { return std::abs(plan::area(r)); });
  std::vector<std::vector<plan::Polygon>> out;
  std::vector<std::size_t> depth, home;  // rings around each ring; the polygon that each outer ring starts
  for (std::size_t i = 0; i < rings.size(); ++i) {
    std::size_t around = 0, parent = 0;
    for (std::size_t j = 0; j < i; ++j)
      if (is_inside(rings[j], rings[i])) ++around, parent = j;
    depth.push_back(around);
    home.push_back(around % 2 == 0 ? out.size() : home[parent]);
    if (around % 2 == 0)
      out.push_back({rings[i]});
    else
      out[home[parent]].push_back(rings[i]);
  }
  return out;
}

}  // namespace visibility::detail
