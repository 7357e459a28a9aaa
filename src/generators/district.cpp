#include "house.hpp"
#include "kind.hpp"
#include "random.hpp"
#include "rotation.hpp"
#include "sites.hpp"

#include <algorithm>

namespace visibility::generators {

namespace {

constexpr double bay = 3, storey = 3.2, chimney = 0.8;  // metres

/// A house for a square lot: any size that leaves two metres around it, gabled, hipped or flat.
House draw_house(Random& random, double lot, int low, int high, double recess)
{
  House h;
  double const most = lot - 4;
  h.length = random.uniform(0.6, 1) * most;
  h.width = random.uniform(0.5, 0.9) * h.length;
  h.storey = storey;
  h.floors = static_cast<std::uint32_t>(random.between(low, high));
  h.bays_along = static_cast<std::uint32_t>(h.length / bay);
  h.bays_across = static_cast<std::uint32_t>(h.width / bay);
  h.recess = recess;
  int const roof = random.between(0, 2);
  h.roof = roof == 0 ? 0 : random.uniform(0.2, 0.5) * h.width;
  h.hip = roof == 1 ? 0 : h.width / 2;
  double const eaves = h.floors * storey, top = eaves + h.roof + random.uniform(0.5, 1.5);
  double const x = h.length / 2 - h.width / 4, y = h.width / 8;
  for (int n = random.between(1, 3); n > 0; --n) {
    Point3d const at{random.uniform(-x, x - chimney), random.uniform(-y, y - chimney), eaves - 0.5};
    h.chimneys.push_back({at, {at.x + chimney, at.y + chimney, top}});
  }
  return h;
}

/// Durand et al. 2000, section 7.1: "a model of a city district which contains a total number of about 150,000
/// polygons replicated a variable number of times", 12 times for 1.8 million. The paper shows town houses in streets
/// and gives no more. Here: one house to a square lot, lots in blocks, streets between, houses with recessed windows,
/// gabled, hipped or flat roofs and chimneys, all of them closed meshes.
///
/// Copies are the same houses in another place, row by row in a square about the origin; `rotation` turns the whole
/// town about the origin, for faces that are not axis-aligned.
void make_district(Parameters const& p, SceneBuilder& scene)
{
  auto const n = p.integer("n"), copies = p.integer("copies");
  int const low = static_cast<int>(p.integer("low")), high = static_cast<int>(p.integer("high"));
  p.require(low <= high, "low must not exceed high");
  double const windows = p.number("windows"), recess = p.number("recess"), street = p.number("street");
  TownAxis const axis{p.number("lot"), street, street, static_cast<std::int64_t>(p.integer("block")), 0};
  double const around = 4 * axis.lot / bay;  // at most so many bays to a floor
  p.require(static_cast<double>(n) * static_cast<double>(copies) * (around * 18 * (high + 1) + 50) < 3e9,
            "so many houses may be over 3 * 10^9 triangles");

  // The period of the copies: the square of rings that holds n lots, and a street.
  std::int64_t rings = 1;
  while (static_cast<std::uint64_t>(4 * rings * rings) < n) ++rings;
  double const period = 2 * axis(rings - 1) + axis.lot + street;
  std::int64_t columns = 1;
  while (static_cast<std::uint64_t>(columns * columns) < copies) ++columns;
  std::int64_t const rows = (static_cast<std::int64_t>(copies) + columns - 1) / columns;
  auto const turn = direction(p.number("rotation"));

  for (std::uint64_t copy = 0; copy < copies; ++copy) {
    auto const c = static_cast<std::int64_t>(copy);
    double const shift_x = static_cast<double>(c % columns - columns / 2) * period;
    double const shift_y = static_cast<double>(c / columns - rows / 2) * period;
    for (std::uint64_t i = 0; i < n; ++i) {
      Random random(p.seed(), "house", i), facade(p.seed(), "windows", i);
      auto house = draw_house(random, axis.lot, low, high, recess);
      house.window = [&] { return facade.chance(windows); };
      bool const across = random.chance(0.5);
      auto const site = ring_site(i);
      Point2d const at{axis(site.i) + shift_x, axis(site.j) + shift_y};
      scene.begin_object("building " + std::to_string(copy * n + i + 1));
      add_house(scene, house, [&](Point3d const& q) {
        double const x = at.x + (across ? -q.y : q.x), y = at.y + (across ? q.x : q.y);
        return Point3d{x * turn.x - y * turn.y, x * turn.y + y * turn.x, q.z};
      });
    }
  }
}

}  // namespace

Kind district()
{
  return {
    {"district",
     "town houses with windows, roofs and chimneys, replicable (Durand et al. 2000, section 7.1)",
     "district,copies=12",
     {seed(), integer("n", 100, 1, 100'000, "houses of one district"),
      integer("copies", 1, 1, 10'000, "copies of the district, side by side"),
      number("rotation", 0, -180, 180, "turn of the whole town about the vertical, degrees"),
      number("lot", 22, 16, 1000, "side of the square lots, m; a house leaves at least 2 m on each side"),
      integer("block", 5, 1, 1000, "lots along the side of a block"),
      number("street", 14, 0, 1e4, "width of the streets between blocks, m"),
      integer("low", 4, 1, 100, "least number of floors"), integer("high", 8, 1, 100, "greatest number of floors"),
      number("windows", 0.9, 0, 1, "share of the bays that have a window"),
      number("recess", 0.2, 0.001, 0.8, "depth of the windows behind the wall, m")}},
    make_district};
}

}  // namespace visibility::generators
