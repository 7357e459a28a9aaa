#include "kind.hpp"
#include "random.hpp"
#include "sites.hpp"

namespace visibility::generators {

namespace {

/// Three boxes on top of each other: each stands inside the top face of the one below. Interiors are disjoint, and
/// boxes that touch share the plane z exactly.
void add_tower(SceneBuilder& scene, Box const& hull, Random random)
{
  double const height = hull.max.z - hull.min.z;
  double const first = hull.min.z + random.uniform(0.3, 0.5) * height;
  double const second = hull.min.z + random.uniform(0.6, 0.8) * height;
  auto const inside = [&](Box const& below, double bottom, double top) {
    auto const shrink = [&](double lo, double hi) {
      double const side = hi - lo, width = random.uniform(0.5, 0.9) * side;
      double const start = lo + random.unit() * (side - width);
      return std::pair(start, std::min(start + width, hi));
    };
    auto const [x0, x1] = shrink(below.min.x, below.max.x);
    auto const [y0, y1] = shrink(below.min.y, below.max.y);
    return Box{{x0, y0, bottom}, {x1, y1, top}};
  };
  Box const low{hull.min, {hull.max.x, hull.max.y, first}};
  Box const middle = inside(low, first, second);
  scene.add(low);
  scene.add(middle);
  scene.add(inside(middle, second, hull.max.z));
}

/// Cohen-Or et al. 1998, section 6: buildings with square bases of 100 on a grid, heights uniform in [200, 900], most
/// of them one box, the others three; four buildings are removed in the centre for view cells of 400 x 400 in all.
///
/// Street width. The paper gives none. Its view space consists of the four removed lots, and a lot is a base and half
/// a street on each side: 2 (base + street) = 400, so street = 100 and the free square between the walls has side
/// 3 (base + street) - base = 500. Its table 2 agrees: from central cells of side 90, 80, 70, 60 strong occlusion hides
/// 1431, 2157, 2554, 2799 boxes of this scene, where the table has 1456, 2120, 2521, 2778. (The other reading, that the
/// free square itself has side 400, is street=66.66666666666667; it gives 1687, 2323, 2604, 2837 and cells that touch
/// walls.)
///
/// Number of boxes. 2,500 sites less 4 are 2,496 buildings. The paper's "75 % simple boxes, the rest three boxes each"
/// makes 1872 + 3 * 624 = 3,744 boxes, but it reports 3,324 boxes and 33,240 polygons; even without removing the four
/// it would be 3,750. 3,324 boxes need 414 towers (16.6 %): that is the default here, because its tables count boxes.
/// triples=0.25 gives the paper's words. Ten polygons a box are five faces (no floor) of two triangles.
void make_city(Parameters const& p, SceneBuilder& scene)
{
  constexpr std::uint64_t removed = 4;
  auto const seed = p.seed(), n = p.integer("n"), buildings = n - removed;
  double const base = p.number("base"), pitch = base + p.number("street");
  double const low = p.number("low"), high = p.number("high");
  p.require(low <= high, "low must not exceed high");

  // Choose exactly this many towers, all choices alike [Knuth, The Art of Computer Programming 2, 3.4.2, algorithm S].
  auto towers = static_cast<std::uint64_t>(p.number("triples") * static_cast<double>(buildings) + 0.5);
  Random choice(seed, "triples");
  for (std::uint64_t site = removed; site < n; ++site) {
    auto const [i, j] = ring_site(site);
    double const x = static_cast<double>(i) * pitch + (pitch - base) / 2;
    double const y = static_cast<double>(j) * pitch + (pitch - base) / 2;
    Box const hull{{x, y, 0}, {x + base, y + base, Random(seed, "height", site).uniform(low, high)}};
    scene.begin_object("building " + std::to_string(site - removed + 1));
    if (choice.below(n - site) < towers) {
      --towers;
      add_tower(scene, hull, Random(seed, "tower", site));
    } else {
      scene.add(hull);
    }
  }
}

}  // namespace

Kind city()
{
  return {{"city",
           "grid of boxes and three-box towers, four buildings removed in the centre (Cohen-Or et al. 1998, section 6)",
           "city",
           {seed(), integer("n", 2500, 5, 10'000'000, "building sites, of which the central four stay free"),
            number("triples", 414.0 / 2496, 0, 1, "share of buildings that are towers of three boxes"),
            number("base", 100, 0.001, 1e6, "side of the square bases, m"),
            number("street", 100, 0.001, 1e6, "width of the streets, m"),
            number("low", 200, 0.001, 1e6, "least height, m"), number("high", 900, 0.001, 1e6, "greatest height, m")}},
          make_city};
}

}  // namespace visibility::generators
