#include "kind.hpp"
#include "random.hpp"

namespace visibility::generators {

namespace {

/// Jittered grid of balls, n to a side in each of `dimension` directions, without the one in the middle (grid position
/// n/2), whose cube is centred on the origin seen from above.
///
/// Spacing. Cohen-Or et al. 1998, section 4, has radius R < 1 and cubes of side 2 about the grid points, each ball
/// within its cube: a centre may then move by 1 - R along each axis, and two centres are at least 2R apart, which is
/// the minimum distance of its Poisson model. In metres: spacing >= 2 radius, centres move by at most
/// spacing / 2 - radius times `jitter`. The paper does not give R for the scene of radius 50. Its table 5 does, in
/// effect: with spacing 200 (R = 1/2) strong occlusion hides 8352, 7076, 4524, 2088, 870, 145 balls from cells of side
/// 5, 10, 20, 30, 40, 50 (an estimate from every 29th ball), where the table has 9169, 7481, 4611, 2334, 811, 119;
/// with spacing 150 or 250 the first number is 14703 or 5481.
void make_balls(Parameters const& p, SceneBuilder& scene, int dimension)
{
  auto const n = p.integer("n"), middle = n / 2, layers = dimension == 3 ? n : 1;
  double const radius = p.number("radius"), spacing = p.number("spacing");
  p.require(spacing >= 2 * radius, "spacing must be at least twice the radius, or balls would overlap");
  double const slack = p.number("jitter") * (spacing / 2 - radius);
  auto const at = [=](std::uint64_t i) { return (static_cast<double>(i) - static_cast<double>(middle)) * spacing; };
  for (std::uint64_t k = 0; k < layers; ++k)
    for (std::uint64_t j = 0; j < n; ++j)
      for (std::uint64_t i = 0; i < n; ++i) {
        if (i == middle && j == middle && (dimension == 2 || k == middle)) continue;
        Random random(p.seed(), "centre", (k * n + j) * n + i);
        Point3d centre{at(i) + random.around(slack), at(j) + random.around(slack), 0};
        if (dimension == 3) centre.z = (static_cast<double>(k) + 0.5) * spacing + random.around(slack);
        scene.begin_object("ball " + std::to_string((k * n + j) * n + i + 1));
        scene.add(Ball{centre, radius});
      }
}

std::vector<GeneratorParameter> parameters(double n, double most)
{
  return {seed(), integer("n", n, 2, most, "balls along each side of the grid"),
          number("radius", 50, 0.001, 1e6, "radius, m"),
          number("spacing", 200, 0.002, 1e7, "side of the grid cells, each with one ball inside, m"),
          number("jitter", 1, 0, 1, "how much of the room in its cell a ball uses")};
}

}  // namespace

/// Cohen-Or et al. 1998, section 6: 30^3 balls of radius 50, one removed. The free cube of side `spacing` has its
/// centre at (0, 0, (n/2 + 1/2) spacing).
Kind spheres()
{
  return {{"spheres", "jittered grid of balls, one removed in the middle (Cohen-Or et al. 1998, section 6)", "spheres",
           parameters(30, 400)},
          [](Parameters const& p, SceneBuilder& scene) { make_balls(p, scene, 3); }};
}

/// Cohen-Or et al. 1998, section 4: the circles of the analysis in the plane, here balls with centres in z = 0.
Kind circles()
{
  return {{"circles", "jittered grid of balls in the plane z = 0, one removed (Cohen-Or et al. 1998, section 4)",
           "circles", parameters(100, 4000)},
          [](Parameters const& p, SceneBuilder& scene) { make_balls(p, scene, 2); }};
}

}  // namespace visibility::generators
