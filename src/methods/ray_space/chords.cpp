#include "visibility/methods/ray_space/chords.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <set>
#include <span>

namespace visibility::ray_space {

namespace {

constexpr std::size_t most_points = 32;  ///< of a polyhedron, and of a prism's footprint; all pairs of them for a dozen

static_assert(most_points <= 64);  // what Chords promises

std::uint16_t index(std::size_t i) { return static_cast<std::uint16_t>(i); }

/// Both rings of an upright prism over the convex polygon, in order around it.
void upright(std::span<Point2d const> polygon, double bottom, double top, Chords& out)
{
  out.clear();
  std::size_t const n = polygon.size();
  for (double const z : {bottom, top})
    for (auto const& p : polygon) out.points.push_back({p.x, p.y, z});
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      auto& chords = j == i + 1 || (i == 0 && j == n - 1) ? out.edges : out.others;
      chords.push_back({index(i), index(j), true, true});
    }
  out.upright = true;
}

void all_pairs(Chords& out)
{
  for (std::size_t i = 0; i < out.points.size(); ++i)
    for (std::size_t j = i + 1; j < out.points.size(); ++j) out.edges.push_back({index(i), index(j), true, true});
}

/// Some of the points that are extreme in many directions.
std::vector<Point3d> outermost(std::vector<Point3d> const& points)
{
  std::set<std::size_t> chosen;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        auto const along = [&](Point3d const& p) { return x * p.x + y * p.y + z * p.z; };
        chosen.insert(static_cast<std::size_t>(std::ranges::max_element(points, {}, along) - points.begin()));
      }
  std::vector<Point3d> out;
  for (auto const i : chosen) out.push_back(points[i]);
  return out;
}

/// Whether half of the vertices lie at one height and the others right above them; fills `out` if so. Requires: no more
/// than most_points vertices.
bool upright(ConvexPolyhedron const& p, Chords& out)
{
  double const bottom = std::ranges::min(p.vertices, {}, &Point3d::z).z;
  constexpr std::size_t none = most_points;
  std::array<std::size_t, most_points> position;  // in the lower ring
  position.fill(none);
  for (std::size_t i = 0; i < p.vertices.size(); ++i)
    if (p.vertices[i].z == bottom) position[i] = out.points.size(), out.points.push_back(p.vertices[i]);
  std::size_t const n = out.points.size();
  if (2 * n != p.vertices.size()) return false;
  double const top = std::ranges::max(p.vertices, {}, &Point3d::z).z;
  for (std::size_t i = 0; i < n; ++i) {
    Point3d const above{out.points[i].x, out.points[i].y, top};
    if (std::ranges::find(p.vertices, above) == p.vertices.end()) return false;
    out.points.push_back(above);
  }
  std::bitset<most_points * most_points> is_edge;
  for (auto const& e : p.edges) {
    auto const i = position[static_cast<std::size_t>(e.from)], j = position[static_cast<std::size_t>(e.to)];
    if (i < n && j < n) is_edge.set(std::min(i, j) * most_points + std::max(i, j));
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      (is_edge[i * most_points + j] ? out.edges : out.others).push_back({index(i), index(j), true, true});
  return out.upright = true;
}

}  // namespace

void chords_of(Box const& b, Chords& out)
{
  std::array<Point2d, 4> const plan{{{b.min.x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, b.max.y}, {b.min.x, b.max.y}}};
  upright(plan, b.min.z, b.max.z, out);
}

void chords_of(Ball const& b, Chords& out)
{
  out.clear();
  // A little inside, so that rounding leaves the points in the ball; it must not be far off its size for that.
  double const r = b.radius * (1 - 0x1p-40), d = r * 0.57735;
  Point3d const& c = b.centre;
  if (!(b.radius > 0x1p-10 * (std::fabs(c.x) + std::fabs(c.y) + std::fabs(c.z)))) {
    out.points.push_back(c);
    return;
  }
  for (int i = 0; i < 8; ++i)
    out.points.push_back({c.x + ((i & 1) != 0 ? d : -d), c.y + ((i & 2) != 0 ? d : -d), c.z + ((i & 4) != 0 ? d : -d)});
  for (double const s : {-r, r}) {
    out.points.push_back({c.x + s, c.y, c.z});
    out.points.push_back({c.x, c.y + s, c.z});
    out.points.push_back({c.x, c.y, c.z + s});
  }
  all_pairs(out);
}

void chords_of(ConvexPrism const& p, Chords& out)
{
  std::size_t const n = p.footprint.size();
  if (n <= most_points) return upright(p.footprint, p.bottom, p.top, out);
  std::vector<Point2d> some;
  for (std::size_t i = 0; i < most_points; ++i) some.push_back(p.footprint[i * n / most_points]);
  upright(some, p.bottom, p.top, out);
}

void chords_of(ConvexPolyhedron const& p, Chords& out)
{
  out.clear();
  if (p.vertices.size() > most_points) {
    out.points = outermost(p.vertices);
    return all_pairs(out);
  }
  if (upright(p, out)) return;
  out.clear();
  out.points = p.vertices;
  // The upper ends of slices lie in facets that look up, the lower ones in facets that look down (rounded: a choice).
  std::vector<Chord> edges;
  for (auto const& e : p.edges) edges.push_back({index(e.from), index(e.to), false, false});
  for (auto const& f : p.facets) {
    auto const &a = p.vertices[f.vertices[0]], &b = p.vertices[f.vertices[1]], &c = p.vertices[f.vertices[2]];
    double const up = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    for (auto const e : f.edges) {
      auto& chord = edges[static_cast<std::size_t>(e >= 0 ? e : ~e)];
      chord.top |= up > 0;
      chord.bottom |= up < 0;
    }
  }
  for (auto const& e : edges) (e.top || e.bottom ? out.edges : out.others).push_back(e);
  for (auto& e : out.others) e.top = e.bottom = true;
  if (p.vertices.size() > 12) return;
  for (std::size_t i = 0; i < p.vertices.size(); ++i)
    for (std::size_t j = i + 1; j < p.vertices.size(); ++j)
      if (std::ranges::none_of(p.edges, [&](auto const& e) { return e.from == i && e.to == j; }))
        out.others.push_back({index(i), index(j), true, true});
}

void chords_of(Triangle const& t, Chords& out)
{
  out.clear();
  out.points.assign(t.vertices.begin(), t.vertices.end());
  all_pairs(out);
}

}  // namespace visibility::ray_space
