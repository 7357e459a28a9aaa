#include "cell_points.hpp"

#include "visibility/evidence/witness.hpp"

#include <algorithm>

namespace visibility::detail {

namespace {

Point3d mix(Point3d const& a, Point3d const& b, double t)
{
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

double determinant(Point3d const& u, Point3d const& v, Point3d const& w)
{
  return u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) + u.z * (v.x * w.y - v.y * w.x);
}

Point3d minus(Point3d const& a, Point3d const& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

}  // namespace

CellPoints::CellPoints(ViewCell const& cell, RayScene const& rays) : cell_(cell), rays_(rays)
{
  double const n = static_cast<double>(cell.vertices().size());
  for (auto const& v : cell.vertices()) centre_ = {centre_.x + v.x / n, centre_.y + v.y / n, centre_.z + v.z / n};
  Point3d const d = minus(cell.bounds().max, cell.bounds().min);
  size_ = std::hypot(d.x, d.y, d.z);
  double sum = 0;
  auto const& s = cell.shape();
  for (auto const& f : s.facets) {
    auto const v = [&](std::size_t i) { return minus(s.vertices[f.vertices[i]], centre_); };
    volumes_.push_back(sum += std::fabs(determinant(v(0), v(1), v(2))));
  }
}

Point3d CellPoints::settled(Point3d const& p) const
{
  if (Point3d const s = rays_.snapped(p); in_interior(cell_, s)) return s;
  if (in_interior(cell_, p)) return p;
  for (double pull = 0x1p-40; pull < 1; pull *= 8)
    if (Point3d const q = mix(p, centre_, pull); in_interior(cell_, q)) return q;
  return centre_;
}

Point3d CellPoints::in_volume(Random& random) const
{
  auto const& s = cell_.shape();
  double const x = random.unit() * volumes_.back();
  auto const facet = std::min<std::size_t>(
    static_cast<std::size_t>(std::ranges::upper_bound(volumes_, x) - volumes_.begin()), s.facets.size() - 1);
  // Uniform in the tetrahedron: a cube-root law from the centre, a folded square in the facet.
  double a = random.unit(), b = random.unit();
  if (a + b > 1) a = 1 - a, b = 1 - b;
  auto const& v = s.facets[facet].vertices;
  Point3d const &p = s.vertices[v[0]], &q = s.vertices[v[1]], &r = s.vertices[v[2]];
  Point3d const on{p.x + a * (q.x - p.x) + b * (r.x - p.x), p.y + a * (q.y - p.y) + b * (r.y - p.y),
                   p.z + a * (q.z - p.z) + b * (r.z - p.z)};
  return settled(mix(centre_, on, std::cbrt(random.unit())));
}

Point3d CellPoints::boundary_point(Random& random) const
{
  auto const& s = cell_.shape();
  double const kind = random.unit();
  if (kind < 0.35) return s.vertices[random.below(s.vertices.size())];
  if (kind < 0.75) {
    auto const& e = s.edges[random.below(s.edges.size())];
    return mix(s.vertices[e.from], s.vertices[e.to], random.unit());
  }
  auto const& f = s.facets[random.below(s.facets.size())].vertices;
  return mix(mix(s.vertices[f[0]], s.vertices[f[1]], random.unit()), s.vertices[f[2]], 1 - std::sqrt(random.unit()));
}

Point3d CellPoints::near_boundary(Random& random) const
{
  Point3d p = boundary_point(random);
  if (random.chance(0.5))
    if (Point3d const other = boundary_point(random); other.z > p.z) p = other;
  constexpr double nearest = 1e-6, farthest = 1e-2;  // shares of the way to the centre: a choice
  return settled(mix(p, centre_, random.log_uniform(nearest, farthest)));
}

Point3d CellPoints::any(Random& random) const { return random.chance(0.4) ? in_volume(random) : near_boundary(random); }

Point3d CellPoints::near(Random& random, Point3d const& p, double scale) const
{
  Point3d const d = random.direction();
  double const r = scale * size_;
  Box const& b = cell_.bounds();
  return settled({std::clamp(p.x + r * d.x, b.min.x, b.max.x), std::clamp(p.y + r * d.y, b.min.y, b.max.y),
                  std::clamp(p.z + r * d.z, b.min.z, b.max.z)});
}

std::optional<Point3d> CellPoints::on_line(Random& random, Point3d const& a, Point3d const& b) const
{
  double lo = -HUGE_VAL, hi = HUGE_VAL;
  Point3d const d = minus(b, a);
  auto const& s = cell_.shape();
  for (auto const& f : s.facets) {
    Point3d const &p = s.vertices[f.vertices[0]], u = minus(s.vertices[f.vertices[1]], p),
                  v = minus(s.vertices[f.vertices[2]], p);
    double const at_a = determinant(u, v, minus(a, p)), slope = determinant(u, v, d);
    if (slope == 0) {
      if (at_a >= 0) return {};
      continue;
    }
    double const t = -at_a / slope;
    (slope > 0 ? hi : lo) = slope > 0 ? std::min(hi, t) : std::max(lo, t);
  }
  if (!(lo < hi) || !std::isfinite(lo) || !std::isfinite(hi)) return {};
  Point3d const p = mix(a, b, random.uniform(lo, hi));
  Point3d const q = rays_.snapped(p);
  if (in_interior(cell_, q)) return q;
  if (in_interior(cell_, p)) return p;
  return {};
}

}  // namespace visibility::detail
