#include "kind.hpp"
#include "mesh.hpp"
#include "random.hpp"
#include "rotation.hpp"

#include <algorithm>
#include <cmath>

namespace visibility::generators {

namespace {

/// Leyvand et al. 2003, section 6, figure 12: boxes of arbitrary size up to 10 x 10 x 10 and arbitrary orientation, the
/// area about the view cell cleared. They may overlap. Closed meshes of twelve triangles, exactly convex (mesh.hpp):
/// 336 bytes a box where a ConvexPolyhedron with its edges and lists takes more than twice that.
///
/// Sides are uniform in [small, large] and centres uniform in the field of the given height, whose side follows from
/// `density`, the volume of all boxes (a box counted for its mean volume) over that of the field. Every box keeps
/// clear of the ground and of the column |x|, |y| <= clear; it is the sphere around the largest box that does.
void make_box_field(Parameters const& p, SceneBuilder& scene)
{
  auto const seed = p.seed(), n = p.integer("n");
  double const small = p.number("small"), large = p.number("large"), height = p.number("height");
  p.require(small <= large, "small must not exceed large");
  double const reach = 0.8660254037844387 * large;  // sqrt(3)/2, rounded up
  p.require(height >= 2 * reach, "height must be at least sqrt(3) times large, or a turned box may not fit");
  double const mean = (small + large) / 2, volume = mean * mean * mean * static_cast<double>(n) / p.number("density");
  double const hole = p.number("clear") + reach;
  // The cleared column comes on top of the volume; a rim of 10 % about it leaves room for the few boxes of a tiny field.
  double const half = std::max(std::sqrt(volume / height + 4 * hole * hole) / 2, 1.1 * hole);

  for (std::uint64_t i = 0; i < n; ++i) {
    Random random(seed, "box", i);
    Rotation const turn = any_rotation(random);
    Point3d const size{random.uniform(small, large), random.uniform(small, large), random.uniform(small, large)};
    Point3d centre{0, 0, random.uniform(reach, height - reach)};
    do {
      centre.x = random.around(half);
      centre.y = random.around(half);
    } while (std::abs(centre.x) <= hole && std::abs(centre.y) <= hole);
    auto corners = Box{{-size.x / 2, -size.y / 2, -size.z / 2}, {size.x / 2, size.y / 2, size.z / 2}}.corners();
    for (auto& c : corners) {
      c = turn(c);
      c = {c.x + centre.x, c.y + centre.y, std::max(0.0, c.z + centre.z)};
    }
    scene.begin_object("box " + std::to_string(i + 1));
    add_hexahedron(scene, corners);
  }
}

}  // namespace

Kind box_field()
{
  return {{"box-field",
           "boxes of any size and orientation around a cleared column (Leyvand et al. 2003, section 6, figure 12)",
           "box-field,n=1725000",
           {seed(), integer("n", 10'000, 1, 50'000'000, "boxes, 12 triangles each"),
            number("small", 1, 0.001, 1e4, "least side of a box, m"),
            number("large", 10, 0.001, 1e4, "greatest side of a box, m"),
            number("height", 50, 0.01, 1e5, "height of the field, m"),
            number("density", 0.05, 1e-9, 10, "volume of the boxes / volume of the field"),
            number("clear", 20, 0, 1e5, "half side of the square around the origin that stays free, m")}},
          make_box_field};
}

}  // namespace visibility::generators
