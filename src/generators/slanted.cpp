#include "kind.hpp"
#include "mesh.hpp"
#include "random.hpp"
#include "rotation.hpp"
#include "sites.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient2d.hpp"

#include <cmath>

namespace visibility::generators {

namespace {

using Quad = std::array<Point2d, 4>;

bool strictly_convex(Quad const& q)
{
  for (std::size_t i = 0; i < 4; ++i)
    if (!is_positive(orient2d<Filtered>(q[i], q[(i + 1) % 4], q[(i + 2) % 4]))) return false;
  return true;
}

/// A quadrilateral without parallel sides in the disc: one corner in each quarter of a turned cross.
Quad footprint(Random& random, Point2d centre, double radius)
{
  for (;;) {
    Quad q;
    double const turn = random.uniform(0, 90);
    for (int i = 0; i < 4; ++i) {
      auto const [c, s] = direction(turn + 90 * i - 180 + random.around(25));
      double const r = radius * random.uniform(0.5, 1);
      q[static_cast<std::size_t>(i)] = {centre.x + r * c, centre.y + r * s};
    }
    if (strictly_convex(q)) return q;
  }
}

/// Closed: walls exactly vertical, floor at z = 0, and above it the two triangles of the four slanting top edges that
/// bulge outward, so that the solid is exactly convex. 8 + 2 + 2 triangles.
void add_building(SceneBuilder& scene, Quad const& q, std::array<double, 4> const& heights)
{
  std::array<std::uint32_t, 4> low{}, high{};
  std::array<Point3d, 4> top;
  for (std::size_t i = 0; i < 4; ++i) {
    top[i] = {q[i].x, q[i].y, heights[i]};
    low[i] = scene.add_vertex({q[i].x, q[i].y, 0});
    high[i] = scene.add_vertex(top[i]);
  }
  for (std::size_t i = 0, j = 1; i < 4; ++i, j = (j + 1) % 4) {
    scene.add_triangle(low[i], low[j], high[j]);
    scene.add_triangle(low[i], high[j], high[i]);
  }
  add_convex_quad(scene, high, top);
  scene.add_triangle(low[0], low[2], low[1]);
  scene.add_triangle(low[0], low[3], low[2]);
}

/// Bittner et al. 2005, section 6.1, scene "Random": a random 2.5D scene of 1 square kilometre whose top edges slant,
/// so that events of three edges are common; nothing is parallel, level or axis-aligned. The paper says no more than
/// 42,801 triangles, 42,801 occluders. A closed triangle mesh always has an even number of triangles; the nearest
/// whole number of buildings is 3,567 with 42,804.
///
/// From its figure 8 (72, 173 and 1,554 of the objects seen from cells 2, 4.6 and 7.2 m high) most tops must lie
/// between 4 and 8 m: corner heights are uniform there. One building to a site, sites on a square grid of `pitch`
/// (17 m: 3,567 of them on 1.03 square kilometres), each in a disc within its site; the four sites about the origin
/// stay free for view cells.
void make_slanted(Parameters const& p, SceneBuilder& scene)
{
  constexpr std::uint64_t free_sites = 4;
  auto const n = p.integer("n");
  double const pitch = p.number("pitch"), radius = p.number("radius"), low = p.number("low"), high = p.number("high");
  p.require(2 * radius <= pitch, "radius must not exceed half the pitch, or buildings would overlap");
  p.require(low <= high, "low must not exceed high");
  double const slack = pitch / 2 - radius;
  for (std::uint64_t i = 0; i < n; ++i) {
    Random random(p.seed(), "building", i);
    auto const site = ring_site(i + free_sites);
    Point2d const centre{(static_cast<double>(site.i) + 0.5) * pitch + random.around(slack),
                         (static_cast<double>(site.j) + 0.5) * pitch + random.around(slack)};
    auto const base = footprint(random, centre, radius);
    std::array<double, 4> heights{};
    for (auto& h : heights) h = random.uniform(low, high);
    scene.begin_object("building " + std::to_string(i + 1));
    add_building(scene, base, heights);
  }
}

}  // namespace

Kind slanted()
{
  return {{"slanted",
           "random 2.5D buildings in general position with slanting top edges (Bittner et al. 2005, section 6.1)",
           "slanted",
           {seed(), integer("n", 3567, 1, 10'000'000, "buildings, 12 triangles each"),
            number("pitch", 17, 0.001, 1e5, "side of the square site of each building, m"),
            number("radius", 7, 0.001, 1e5, "radius of the disc that holds a footprint, m"),
            number("low", 4, 0.001, 1e5, "least height of a top corner, m"),
            number("high", 8, 0.001, 1e5, "greatest height of a top corner, m")}},
          make_slanted};
}

}  // namespace visibility::generators
