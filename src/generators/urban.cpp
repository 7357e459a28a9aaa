#include "kind.hpp"
#include "mesh.hpp"
#include "random.hpp"
#include "rotation.hpp"
#include "sites.hpp"

#include <algorithm>
#include <cmath>

namespace visibility::generators {

namespace {

/// A rectangle in the building's own plan, whose centre is (0, 0).
struct Rectangle {
  Point2d min, max;
};

Rectangle shrunk(Rectangle const& r, double by) { return {{r.min.x + by, r.min.y + by}, {r.max.x - by, r.max.y - by}}; }

struct Building {
  std::vector<Rectangle> parts;
  int decks = 0, floors = 0;
  Point2d centre{}, turn{};  ///< turn: (cos, sin) of the rotation about the vertical
  Rotation tilt{};
  bool tilted = false;
  double lift = 0;
};

/// The letters are made of bars a third of the plan wide. A bar that joins another ends in the middle of it: bars that
/// overlap leave no slit, whatever the rounding of their turned corners, where bars that only touch might.
std::vector<Rectangle> plan(double letter, double h_share, double t_share, double length, double width)
{
  double const x = length / 2, y = width / 2;
  if (letter < h_share)
    return {{{-x, -y}, {-x / 3, y}}, {{x / 3, -y}, {x, y}}, {{-x * 2 / 3, -y / 3}, {x * 2 / 3, y / 3}}};
  if (letter < h_share + t_share) return {{{-x, y / 3}, {x, y}}, {{-x / 3, -y}, {x / 3, y * 2 / 3}}};
  return {{{-x, -y}, {x, y}}};
}

class Mason {
public:
  Mason(SceneBuilder& scene, Building const& building) : scene_(scene), b_(building) {}

  void block(Rectangle const& r, double bottom, double top)
  {
    std::array<Point2d, 4> const plan{{r.min, {r.max.x, r.min.y}, r.max, {r.min.x, r.max.y}}};
    std::array<Point2d, 4> turned;
    std::ranges::transform(plan, turned.begin(), [this](Point2d const& p) {
      return Point2d{p.x * b_.turn.x - p.y * b_.turn.y, p.x * b_.turn.y + p.y * b_.turn.x};
    });
    if (b_.tilted) return leaning_block(turned, bottom, top);
    for (auto& p : turned) p = {b_.centre.x + p.x, b_.centre.y + p.y};
    add_prism(scene_, turned, bottom, top);
  }

private:
  void leaning_block(std::array<Point2d, 4> const& q, double bottom, double top)
  {
    std::array<Point3d, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
      auto const& p = q[(i & 1) != 0 ? ((i & 2) != 0 ? 2 : 1) : ((i & 2) != 0 ? 3 : 0)];  // as Box::corner counts
      auto const t = b_.tilt({p.x, p.y, (i & 4) != 0 ? top : bottom});
      corners[i] = {b_.centre.x + t.x, b_.centre.y + t.y, std::max(0.0, t.z + b_.lift)};
    }
    add_hexahedron(scene_, corners);
  }

  SceneBuilder& scene_;
  Building const& b_;
};

/// One storey of a parking deck: a slab of the part's outline on four columns, open on all sides.
void add_deck(Mason& mason, Rectangle const& part, double bottom, double storey)
{
  constexpr double column = 0.4, inset = 0.3, slab = 0.1;  // metres, metres, share of the storey
  double const ceiling = bottom + (1 - slab) * storey;
  auto const inner = shrunk(part, inset);
  for (double const x : {inner.min.x, inner.max.x - column})
    for (double const y : {inner.min.y, inner.max.y - column})
      mason.block({{x, y}, {x + column, y + column}}, bottom, ceiling);
  mason.block(part, ceiling, bottom + storey);
}

void add_building(SceneBuilder& scene, Building const& b, double storey, double ledge)
{
  Mason mason(scene, b);
  auto const level = [storey](int k) { return k * storey; };
  for (auto const& part : b.parts) {
    for (int k = 0; k < b.decks; ++k) add_deck(mason, part, level(k), storey);
    for (int k = b.decks; k < b.decks + b.floors; ++k)
      mason.block((k - b.decks) % 2 == 0 ? shrunk(part, ledge) : part, level(k), level(k + 1));
  }
}

double power(double base, std::uint64_t exponent)
{
  double result = 1;
  for (; exponent > 0; --exponent) result *= base;
  return result;
}

/// Leyvand et al. 2003, section 6, figures 1 and 11: "a randomly generated urban model controlled by a large set of
/// parameters which define model size, density, distribution of heights, regularity, etc. Some of the buildings consist
/// of parts of the shape of the letters H and T, and some buildings have a number of parking decks in their first
/// floors ... the buildings consist of several floors, each being a 3D box. The buildings are between 9-12 units in
/// width and length and are rotated by at most 30 degrees about the axes". 26.8 million triangles; cells on the
/// junction of two long avenues; in table 3, 30 % of the occluders are not 2.5D, which is the default of `decks` here.
///
/// Rotation is about the vertical, by an angle uniform in [-rotation, rotation]: the paper compares with 2.5D
/// occluders, so its buildings stand upright. `tilt` leans them about x and y as well, for the other reading; leaning
/// buildings may reach into each other and into the avenues, all others stay on their lots.
///
/// Every second floor is set back by `ledge`. Flush floors (ledge=0) would share edges, and a reader that welds equal
/// corners then sees one surface with four walls at an edge instead of a stack of convex solids.
///
/// Each floor of each part is a closed mesh of 12 triangles; a deck takes 5 such boxes a part.
class City {
public:
  explicit City(Parameters const& p)
    : p_(p), seed_(p.seed()), least_(p.number("small")), most_(p.number("large")), storey_(p.number("storey")),
      ledge_(p.number("ledge")), axis_{p.number("lot"), p.number("street"), p.number("avenue"),
                                       static_cast<std::int64_t>(p.integer("block")),
                                       static_cast<std::int64_t>(p.integer("blocks"))}
  {
    p.require(least_ <= most_, "small must not exceed large");
    p.require(floors_least() <= floors_most(), "low must not exceed high");
    p.require(p.number("h") + p.number("t") <= 1, "h and t are shares of all buildings: together at most 1");
    p.require(axis_.lot >= diagonal * most_,
              "lot must be at least sqrt(2) times large, or turned buildings would overlap");
    p.require(static_cast<double>(p.integer("n")) * (36.0 * floors_most() + 180.0 * deck_most()) < 3e9,
              "n buildings so high may be over 3 * 10^9 triangles");
  }

  void build(SceneBuilder& scene) const
  {
    auto const n = p_.integer("n");
    double const density = p_.number("density");
    for (std::uint64_t lot = 0, built = 0; built < n; ++lot) {
      if (!Random(seed_, "density", lot).chance(density)) continue;
      scene.begin_object("building " + std::to_string(++built));
      add_building(scene, building(lot), storey_, ledge_);
    }
  }

private:
  static constexpr double diagonal = 1.4142135623730951;  // sqrt(2), rounded up

  int floors_least() const { return static_cast<int>(p_.integer("low")); }
  int floors_most() const { return static_cast<int>(p_.integer("high")); }
  int deck_most() const { return static_cast<int>(p_.integer("deck-floors")); }

  Building building(std::uint64_t lot) const
  {
    Building b;
    Random shape(seed_, "shape", lot), height(seed_, "height", lot), decks(seed_, "decks", lot);
    double const length = shape.uniform(least_, most_), width = shape.uniform(least_, most_);
    b.parts = plan(shape.unit(), p_.number("h"), p_.number("t"), length, width);
    double const skewed = power(height.unit(), p_.integer("skew"));
    int const span = floors_most() - floors_least();
    b.floors = floors_least() + std::min(span, static_cast<int>(skewed * (span + 1)));
    if (decks.chance(p_.number("decks")) && deck_most() > 0) b.decks = decks.between(1, deck_most());

    Random place(seed_, "place", lot);
    auto const site = ring_site(lot);
    double const slack = (1 - p_.number("regularity")) * (axis_.lot - diagonal * most_) / 2;
    b.centre = {axis_(site.i) + place.around(slack), axis_(site.j) + place.around(slack)};
    b.turn = direction(place.around(p_.number("rotation")));
    if (double const most = p_.number("tilt"); most > 0) {
      double const x = place.around(most), y = place.around(most);  // in this order, unlike arguments of a call
      lean(b, x, y, length, width);
    }
    return b;
  }

  static void lean(Building& b, double x, double y, double length, double width)
  {
    b.tilted = true;
    auto const first = about_x(x), second = about_y(y);
    auto const column = [&](Point3d const& e) { return second(first(e)); };
    auto const c0 = column({1, 0, 0}), c1 = column({0, 1, 0}), c2 = column({0, 0, 1});
    b.tilt = {{{{c0.x, c1.x, c2.x}, {c0.y, c1.y, c2.y}, {c0.z, c1.z, c2.z}}}};
    // The lowest corner of the plan comes to stand on the ground; turning the plan by b.turn first moves its corners.
    for (double const sx : {-0.5, 0.5})
      for (double const sy : {-0.5, 0.5}) {
        Point2d const q{sx * length, sy * width};
        auto const t = b.tilt({q.x * b.turn.x - q.y * b.turn.y, q.x * b.turn.y + q.y * b.turn.x, 0});
        b.lift = std::max(b.lift, -t.z);
      }
  }

  Parameters const& p_;
  std::uint64_t seed_;
  double least_, most_, storey_, ledge_;
  TownAxis axis_;
};

}  // namespace

Kind urban()
{
  return {{"urban",
           "turned buildings of H, T and plain plan with floors and parking decks along avenues (Leyvand et al. 2003, "
           "section 6)",
           "urban,n=120350",
           {seed(),
            integer("n", 2000, 1, 10'000'000, "buildings"),
            number("density", 0.8, 0.01, 1, "share of the lots that are built on"),
            number("regularity", 0.5, 0, 1, "1: buildings stand in the middle of their lots, 0: anywhere that fits"),
            number("rotation", 30, 0, 90, "greatest turn about the vertical, degrees"),
            number("tilt", 0, 0, 30, "greatest turn about the two horizontal axes, degrees"),
            number("small", 9, 6, 1000, "least width and length of a building, m"),
            number("large", 12, 6, 1000, "greatest width and length of a building, m"),
            integer("low", 3, 1, 1000, "least number of floors above the decks"),
            integer("high", 20, 1, 1000, "greatest number of floors above the decks"),
            integer("skew", 2, 1, 10, "distribution of heights: 1 uniform, more: the low ones more frequent"),
            number("storey", 3, 0.1, 100, "height of a floor, m"),
            number("ledge", 0.1, 0, 0.4, "set-back of every second floor, m"),
            number("h", 0.2, 0, 1, "share of buildings in the shape of an H"),
            number("t", 0.2, 0, 1, "share of buildings in the shape of a T"),
            number("decks", 0.3, 0, 1, "share of buildings with parking decks in their lower floors"),
            integer("deck-floors", 3, 0, 10, "most parking decks of a building"),
            number("lot", 20, 1, 1e4, "side of the square lots, m"),
            integer("block", 4, 1, 1000, "lots along the side of a block"),
            number("street", 12, 0, 1e4, "width of the streets between blocks, m"),
            integer("blocks", 20, 0, 10'000, "blocks between avenues; 0: only the two that cross in the origin"),
            number("avenue", 30, 0, 1e4, "width of the avenues, m")}},
          [](Parameters const& p, SceneBuilder& scene) { City(p).build(scene); }};
}

}  // namespace visibility::generators
