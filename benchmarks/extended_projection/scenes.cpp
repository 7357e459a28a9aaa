#include "scenes.hpp"

#include "visibility/evidence/ray_scene.hpp"
#include "visibility/methods/sampling/method.hpp"

#include <cmath>

namespace visibility::bench::extended_projection {

Model::Model(std::string const& specification, bool inner_bodies)
  : name(specification), scene(generate(specification)),
    prepared(inner_bodies ? std::make_unique<PreparedScene>(scene, InnerBodyOptions{})
                          : std::make_unique<PreparedScene>(scene))
{
}

std::vector<ViewCell> street_cells(int count, double bottom)
{
  std::vector<ViewCell> cells;
  for (int i = 0; i < count; ++i) {
    double const at = 10 + 4.0 * (i / 2);
    cells.emplace_back(i % 2 == 0 ? Box{{at, -5, bottom}, {at + 4, 5, 2}} : Box{{-5, at, bottom}, {5, at + 4, 2}});
  }
  return cells;
}

std::vector<ViewCell> turned_street_cells(int count, double length, double degrees)
{
  double const angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  std::vector<ViewCell> cells;
  for (int i = 0; i < count; ++i) {
    double const at = 10 + 4.0 * (i / 2);
    Box const b = i % 2 == 0 ? Box{{at, -5, 0.5}, {at + length, 5, 2}} : Box{{-5, at, 0.5}, {5, at + length, 2}};
    if (degrees == 0) {
      cells.emplace_back(b);
      continue;
    }
    std::vector<Point3d> corners;
    for (auto const& p : b.corners()) corners.push_back({c * p.x - s * p.y, s * p.x + c * p.y, p.z});
    cells.push_back(ViewCell::hull(corners));
  }
  return cells;
}

std::vector<ViewCell> tilted_street_cells(int count, double length, double degrees)
{
  double const angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  std::vector<ViewCell> cells;
  for (int i = 0; i < count; ++i) {
    double const at = 10 + 4.0 * (i / 2);
    std::vector<Point3d> corners;
    for (auto const& p : Box{{0, -3, 0}, {length, 3, 1.5}}.corners()) {
      double const along = at + c * p.x - s * (p.z - 1.5), z = 0.5 + s * p.x + c * p.z;
      corners.push_back(i % 2 == 0 ? Point3d{along, p.y, z} : Point3d{p.y, along, z});
    }
    cells.push_back(ViewCell::hull(corners));
  }
  return cells;
}

std::vector<ViewCell> crown_cells(int count, double side)
{
  std::vector<ViewCell> cells;
  for (int i = 0; i < count; ++i) {
    double const x = i % 3 - 1 - side / 2, y = i / 3 % 3 - 1 - side / 2;
    cells.emplace_back(Box{{x, y, 5.5}, {x + side, y + side, 5.5 + side}});
  }
  return cells;
}

double mean_seen(Model const& model, std::vector<ViewCell> const& cells, std::uint64_t rays)
{
  RayScene const scene(*model.prepared);
  Sampling const sampling({.rays = rays, .threads = 1});
  double seen = 0;
  for (auto const& cell : cells) seen += static_cast<double>(sampling(scene, cell).visible.size());
  return seen / static_cast<double>(cells.size());
}

double fitted_exponent(std::vector<std::pair<double, double>> const& points)
{
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (auto const& [a, b] : points) {
    double const u = std::log(a), v = std::log(b);
    n += 1;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace visibility::bench::extended_projection
