#include "experiments.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/methods/strong_occlusion/survey.hpp"
#include "visibility/scene/generators.hpp"

#include <optional>

namespace visibility::bench::strong_occlusion {

namespace {

/// A column of tables 1 and 2.
struct Published {
  double side, polygons, buildings, boxes, box_rays, polygon_rays;
  std::optional<double> seconds;
};

std::vector<Published> const published{
  {200, 24534, 89, 11, 132703, 1175813, {}},   {150, 20470, 241, 39, 171463, 1346399, {}},
  {125, 16995, 438, 100, 208280, 1385075, {}}, {100, 11338, 974, 337, 273029, 1204630, {}},
  {90, 7745, 1806, 1456, 255315, 707462, 47},  {80, 5464, 2329, 2120, 245076, 425117, 33},
  {70, 4090, 2623, 2521, 234380, 259442, 25},  {60, 3128, 2829, 2778, 227892, 159599, 18},
  {50, 2540, 2947, 2918, 222611, 109210, 16},  {40, 2115, 3019, 2994, 218785, 85313, 15},
  {30, 1833, 3067, 3052, 215838, 64846, 14},   {20, 1615, 3102, 3088, 212943, 55621, 13},
  {10, 1447, 3126, 3116, 211715, 48002, {}}};

}  // namespace

void cell_sizes(Report& report, Size size)
{
  Scene const scene = generate(city(size));
  PreparedScene const prepared(scene);
  auto const survey = [&](double side, Options const& o) {
    return visibility::strong_occlusion::survey<Filtered>(prepared, ground_cell(side), o);
  };
  auto const box_rays = [](auto const& s) { return static_cast<double>(s.counts.rays - s.counts.face_rays); };

  auto& sets = report.table("Tables 1 and 2: what is hidden, by cell side (paper | ours)",
                            {"side", "visible polygons", "ours", "hidden piecewise", "ours", "hidden boxes", "ours"});
  for (auto const& p : published) {
    auto const s = survey(p.side, Options{});
    sets.add({p.side, p.polygons, double(s.visible_polygons), p.buildings, double(s.hidden_piecewise), p.boxes,
              double(s.hidden_bodies)});
  }
  sets.notes = {"Boxes: of 3324. Polygons: two triangles a face; the paper counts faces that look away from the cell,",
                "we do not: at most three of five face a cell."};

  auto& cost =
    report.table("Tables 1 and 2: cost, by cell side (paper | ours as published: leading ray, 64 sight lines | ours)",
                 {"side", "ray/box", "as published", "ours", "ray/polygon", "as published", "ours", "paper, s",
                  "ours, ms", "exact / double"});
  std::vector<std::array<double, 4>> effectiveness;
  for (auto const& p : published) {
    auto const plain = survey(p.side, as_published()), all = survey(p.side, Options{});
    auto const cell = ground_cell(p.side);
    auto const [exact, rounded] = medians_in_turn(
      size == Size::full ? 31 : 1, [&] { StrongOcclusion<>()(prepared, cell); },
      [&] { StrongOcclusion<Double>()(prepared, cell); });
    cost.add({p.side, p.box_rays, box_rays(plain), box_rays(all), p.polygon_rays, double(plain.counts.face_rays),
              double(all.counts.face_rays), p.seconds ? Value(*p.seconds) : Value(), 1e3 * exact, exact / rounded});
    effectiveness.push_back({p.side, 1e3 * p.boxes / p.box_rays, 1e3 * double(plain.hidden_bodies) / box_rays(plain),
                             1e3 * double(all.hidden_bodies) / box_rays(all)});
  }
  cost.notes = {"Sight lines tested exactly; ours looks for candidates with bounding boxes besides.",
                "Time: one core, whole set at face granularity, hierarchy built."};

  auto& figure =
    report.table("Figure 5: boxes hidden for 1000 ray/box tests, (a) of one cell, (b) of the whole viewspace",
                 {"side", "(a) paper", "as published", "ours", "(b) paper", "as published", "ours"});
  for (auto const& e : effectiveness) {
    double const share = e[0] * e[0] / (400 * 400);
    figure.add({e[0], e[1], e[2], e[3], e[1] * share, e[2] * share, e[3] * share});
  }
  figure.notes = {
    "(b): (a) times the cell's share of the viewspace of 400 x 400. Paper: computed from its tables 1 and 2."};
}

}  // namespace visibility::bench::strong_occlusion
