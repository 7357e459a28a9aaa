#include "kind.hpp"
#include "mesh.hpp"
#include "random.hpp"
#include "rotation.hpp"
#include "sites.hpp"

#include <cmath>

namespace visibility::generators {

namespace {

/// Axis-aligned ellipsoid of revolution.
struct Crown {
  Point3d centre;
  double radius, half_height;

  /// How far out p lies: 1 on the surface.
  double level(Point3d const& p) const
  {
    double const x = (p.x - centre.x) / radius, y = (p.y - centre.y) / radius, z = (p.z - centre.z) / half_height;
    return x * x + y * y + z * z;
  }
  Point3d at(Point3d const& in_unit_ball) const
  {
    return {centre.x + radius * in_unit_ball.x, centre.y + radius * in_unit_ball.y,
            centre.z + half_height * in_unit_ball.z};
  }
};

/// An equilateral triangle in any direction, centred uniformly in the crown; drawn again until all of it lies inside
/// (that is, its corners: the crown is convex), which thins the leaves out near the surface.
void add_leaf(SceneBuilder& scene, Random& random, Crown const& crown, double leaf)
{
  for (;;) {
    Point3d const c = crown.at(in_unit_ball(random));
    Rotation const turn = any_rotation(random);
    std::array<Point3d, 3> corners{
      {{leaf, 0, 0}, {-leaf / 2, leaf * 0.8660254037844386, 0}, {-leaf / 2, -leaf * 0.8660254037844386, 0}}};
    bool inside = true;
    for (auto& v : corners) {
      v = turn(v);
      v = {c.x + v.x, c.y + v.y, c.z + v.z};
      inside = inside && crown.level(v) <= 1;
    }
    if (!inside) continue;
    auto const a = scene.add_vertex(corners[0]), b = scene.add_vertex(corners[1]), d = scene.add_vertex(corners[2]);
    return scene.add_triangle(a, b, d);
  }
}

/// Hexagonal, from the ground to the middle of the crown: 20 triangles.
void add_trunk(SceneBuilder& scene, Crown const& crown)
{
  std::array<Point2d, 6> footprint;
  for (int i = 0; i < 6; ++i) {
    auto const [c, s] = direction(60 * i - 180);
    double const r = 0.06 * crown.radius;
    footprint[static_cast<std::size_t>(i)] = {crown.centre.x + r * c, crown.centre.y + r * s};
  }
  add_prism(scene, footprint, 0, crown.centre.z);
}

/// Durand et al. 2000, section 7.2: "a forest containing around 7,750 trees with 1,000 leaves each (7.8M triangles)",
/// leaves being single triangles and large for a tree. (7,750 trees are 7.75 million triangles.) The paper says nothing
/// of trunks, shapes or distances.
///
/// Trees stand on a grid of `spacing`, moved by up to `jitter` of half a cell along each axis; crowns of neighbours
/// may mingle. Every tree is scaled by a factor uniform in [0.75, 1.25], with its crown's lower end 30 % of its
/// height above the ground. The square of four sites about the origin has no tree; crowns may hang into it.
void make_forest(Parameters const& p, SceneBuilder& scene)
{
  constexpr std::uint64_t free_sites = 4;
  auto const n = p.integer("n"), leaves = p.integer("leaves");
  double const spacing = p.number("spacing"), radius = p.number("radius"), height = p.number("height");
  double const leaf = p.number("leaf"), slack = p.number("jitter") * spacing / 2;
  bool const trunk = p.integer("trunk") == 1;
  p.require(static_cast<double>(n) * static_cast<double>(leaves + 20) < 1e9,
            "n trees of so many leaves are over 10^9 triangles");
  p.require(leaf <= 0.25 * radius && leaf <= 0.08 * height,
            "leaf must not exceed radius / 4 nor height / 12.5, or leaves hardly fit into a small crown");
  for (std::uint64_t i = 0; i < n; ++i) {
    Random random(p.seed(), "tree", i);
    auto const site = ring_site(i + free_sites);
    double const scale = random.uniform(0.75, 1.25), half_crown = 0.35 * height * scale;
    Point3d const centre{(static_cast<double>(site.i) + 0.5) * spacing + random.around(slack),
                         (static_cast<double>(site.j) + 0.5) * spacing + random.around(slack),
                         height * scale - half_crown};
    Crown const crown{centre, radius * scale, half_crown};
    scene.begin_object("tree " + std::to_string(i + 1));
    Random foliage(p.seed(), "foliage", i);
    for (std::uint64_t k = 0; k < leaves; ++k) add_leaf(scene, foliage, crown, leaf);
    if (trunk) add_trunk(scene, crown);
  }
}

}  // namespace

Kind forest()
{
  return {
    {"forest",
     "trees of 1,000 loose leaf triangles each (Durand et al. 2000, section 7.2)",
     "forest,n=7750",
     {seed(), integer("n", 250, 1, 1'000'000, "trees"), integer("leaves", 1000, 1, 100'000, "leaf triangles of a tree"),
      integer("trunk", 0, 0, 1, "1: each tree has a trunk of 20 triangles too"),
      number("spacing", 6, 0.01, 1e5, "side of the square site of each tree, m"),
      number("jitter", 0.8, 0, 1, "how far a tree may stand off the middle of its site, 1: anywhere in it"),
      number("height", 9, 0.1, 1e4, "height of a tree, m, before the scaling by 0.75 to 1.25"),
      number("radius", 2.5, 0.1, 1e4, "horizontal radius of a crown, m, before the scaling"),
      number("leaf", 0.3, 0.0001, 1e3, "circumradius of a leaf, m")}},
    make_forest};
}

}  // namespace visibility::generators
