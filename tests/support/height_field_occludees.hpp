#pragma once

#include "support/height_field_scenes.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace visibility::test {

/// Recipes of occludees among the columns of a scene; every polygon is exactly planar.
enum class OccludeeShape {
  triangle,    ///< in any position
  level,       ///< a horizontal rectangle
  ramp,        ///< a rectangle in plan that rises along x or y
  gable,       ///< vertical, five corners
  upright,     ///< a vertical rectangle over any segment
  top,         ///< a column's top, or a corner of it
  wall,        ///< a rectangle on a column's wall, or one that sticks out above or beside it
  lifted,      ///< a column's top, a little higher or lower
  cell_height  ///< at the height of the cell's top
};
inline constexpr int occludee_shapes = 9;

namespace detail {

class OccludeeMaker {
public:
  OccludeeMaker(HeightScene kind, Random& random, std::span<oracle::Column const> columns, oracle::Cell const& cell)
    : kind_(kind), random_(random), columns_(columns), cell_(cell)
  {
  }

  std::vector<Point3d> operator()(OccludeeShape shape)
  {
    if (columns_.empty() && is_of_column(shape)) shape = OccludeeShape::level;
    switch (shape) {
    case OccludeeShape::triangle: return triangle();
    case OccludeeShape::level: return rectangle(z(), {});
    case OccludeeShape::ramp: return rectangle(z(), z());
    case OccludeeShape::gable: return gable();
    case OccludeeShape::upright: return fence();
    case OccludeeShape::top: return top();
    case OccludeeShape::wall: return wall();
    case OccludeeShape::lifted: return lifted();
    case OccludeeShape::cell_height: return rectangle(cell_.top, {});
    }
    return {};
  }

private:
  static bool is_of_column(OccludeeShape s)
  {
    return s == OccludeeShape::top || s == OccludeeShape::wall || s == OccludeeShape::lifted;
  }
  bool far() const { return kind_ == HeightScene::far_detail; }
  double size(double d) const { return far() ? d * 0.001 : d; }
  double raw(double lo, double hi)
  {
    bool const anywhere = kind_ == HeightScene::general || kind_ == HeightScene::slanted || random_.chance(0.1);
    return anywhere ? random_.uniform(lo, hi) : random_.between(int(lo), int(hi));
  }
  /// As the scenes place their numbers, each once, so that what shares it stays planar.
  double placed(double v, double origin)
  {
    return kind_ == HeightScene::one_ulp ? jolt(random_, v) : far() ? origin + v * 0.001 : v;
  }
  struct Extent {
    double low, high;
  };
  Extent extent(double origin)
  {
    double const low = raw(-10, 9), length = raw(1, random_.chance(0.2) ? 12 : 3);
    return {placed(low, origin), placed(low + length, origin)};
  }
  Extent along_x() { return extent(1e6); }
  Extent along_y() { return extent(2e6); }
  double z() { return placed(raw(-2, random_.chance(0.3) ? 7 : 3), 0); }

  std::vector<Point3d> triangle()
  {
    auto const x = along_x(), y = along_y();
    Point3d a{x.low, y.low, z()}, b{x.high, y.low, z()}, c{random_.chance(0.5) ? x.low : x.high, y.high, z()};
    if (random_.chance(0.5)) std::swap(a.y, c.y), std::swap(b.x, c.x);
    return {a, b, c};
  }
  /// Level at z, or from z to `end` along an axis.
  std::vector<Point3d> rectangle(double z, std::optional<double> end)
  {
    auto const x = along_x(), y = along_y();
    double const z1 = end.value_or(z);
    bool const rises_along_x = random_.chance(0.5);
    return {{x.low, y.low, z},
            {x.high, y.low, rises_along_x ? z1 : z},
            {x.high, y.high, z1},
            {x.low, y.high, rises_along_x ? z : z1}};
  }
  static std::vector<Point3d> upright(Point3d const& a, Point3d const& b, double low, double high)
  {
    return {{a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, high}, {a.x, a.y, high}};
  }
  std::vector<Point3d> gable()
  {
    bool const crosses_x = random_.chance(0.5);
    auto const x = along_x(), y = along_y();
    auto const [u0, u1] = crosses_x ? x : y;
    double const low = z(), eaves = low + size(1), ridge = eaves + size(random_.unit());
    double const u = u0 + (u1 - u0) * random_.unit();
    auto const at = [&](double v, double h) { return crosses_x ? Point3d{v, y.low, h} : Point3d{x.low, v, h}; };
    return {at(u0, low), at(u1, low), at(u1, eaves), at(u, ridge), at(u0, eaves)};
  }
  std::vector<Point3d> fence()
  {
    auto const x = along_x(), y = along_y();
    double const low = z(), high = low + size(random_.between(1, 2));
    switch (random_.below(3)) {
    case 0: return upright({x.low, y.low, 0}, {x.high, y.low, 0}, low, high);
    case 1: return upright({x.low, y.low, 0}, {x.low, y.high, 0}, low, high);
    default: return upright({x.low, y.high, 0}, {x.high, y.low, 0}, low, high);
    }
  }
  oracle::Column const& column() { return columns_[std::size_t(random_.below(int(columns_.size())))]; }
  std::vector<Point3d> top()
  {
    auto corners = column().corners;
    if (random_.chance(0.5)) corners.erase(corners.begin() + 1, corners.end() - 2);
    return corners;
  }
  std::vector<Point3d> wall()
  {
    auto const& c = column().corners;
    std::size_t const i = std::size_t(random_.below(int(c.size())));
    Point3d a = c[i], b = c[(i + 1) % c.size()];
    if (random_.chance(0.3)) b = c[(i + 2) % c.size()];  // a diagonal, for boxes: inside
    if (random_.chance(0.3)) {                           // longer; exact for walls along an axis
      if (a.x == b.x) a.y += size(random_.between(-2, 2));
      if (a.y == b.y) a.x += size(random_.between(-2, 2));
    }
    double const up = random_.chance(0.5) ? 0 : size(random_.between(-2, 2));
    double const high_a = a.z + up, high_b = b.z + up, low = std::min(high_a, high_b) - size(random_.between(1, 3));
    return {{a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, high_b}, {a.x, a.y, high_a}};
  }
  std::vector<Point3d> lifted()
  {
    auto corners = column().corners;
    bool const level = std::ranges::all_of(corners, [&](Point3d const& p) { return p.z == corners[0].z; });
    double const up = size(random_.between(-1, 2) / 2.0), hair = random_.chance(0.5) ? 0x1p-50 : 0;
    for (auto& p : corners) p.z = level ? corners[0].z : p.z;
    for (auto& p : corners) p.z += up, p.z += hair * p.z;
    return corners;
  }

  HeightScene kind_;
  Random& random_;
  std::span<oracle::Column const> columns_;
  oracle::Cell const& cell_;
};

}  // namespace detail

/// `count` occludees of one to three polygons among the columns of a scene of that kind (in that kind's numbers: on its
/// grid, in its millimetres, an ulp off), some on its tops and walls, some without area.
inline std::vector<oracle::Occludee> random_occludees(HeightScene kind, Random& random,
                                                      std::span<oracle::Column const> columns, oracle::Cell const& cell,
                                                      int count)
{
  detail::OccludeeMaker polygon(kind, random, columns, cell);
  std::vector<oracle::Occludee> out(static_cast<std::size_t>(count));
  for (auto& o : out)
    for (int n = random.chance(0.8) ? 1 : random.between(2, 3); n > 0; --n)
      o.polygons.push_back(polygon(static_cast<OccludeeShape>(random.below(occludee_shapes))));
  return out;
}

}  // namespace visibility::test
