#pragma once

#include "support/random.hpp"
#include "visibility/raster/grid.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

/// Named recipes for small sets of points over a raster, whose hulls are scan converted.
namespace visibility::test {

enum class Shape {
  lattice,        ///< corners of pixels: edges through corners and along pixels
  quarter,        ///< quarters of pixels
  uniform,        ///< anywhere in and around the raster
  sliver,         ///< on one line up to a unit in the last place
  parallel,       ///< two nearly parallel long edges
  tiny,           ///< smaller than a pixel
  large,          ///< up to a million pixels off
  displaced,      ///< corners of pixels, some moved by one unit in the last place
  degenerate,     ///< points and segments, repeated points; on quarters of pixels
  through_corner  ///< a line through two corners of pixels, continued to points that are rounded
};
inline constexpr std::array all_shapes{Shape::lattice,    Shape::quarter,       Shape::uniform, Shape::sliver,
                                       Shape::parallel,   Shape::tiny,          Shape::large,   Shape::displaced,
                                       Shape::degenerate, Shape::through_corner};

inline std::string_view name(Shape shape)
{
  static constexpr std::array<std::string_view, all_shapes.size()> names{
    "lattice", "quarter", "uniform",   "sliver",     "parallel",
    "tiny",    "large",   "displaced", "degenerate", "through_corner"};
  return names[static_cast<std::size_t>(shape)];
}

/// Whether the points are on the fixed grid, so that the answer must be the truth: on a raster whose lines are short.
inline bool is_exact(Shape s) { return s == Shape::lattice || s == Shape::quarter || s == Shape::degenerate; }

class PolygonSource {
public:
  PolygonSource(Grid const& grid, std::uint64_t seed) : grid_(grid), random_(seed) {}

  Random& random() { return random_; }

  /// 1 to 7 points, in any order and orientation.
  std::vector<Point2d> operator()(Shape shape)
  {
    int const n = random_.between(3, random_.chance(0.7) ? 4 : 7);
    std::vector<Point2d> points;
    switch (shape) {
    case Shape::lattice:
    case Shape::displaced:
      for (int i = 0; i < n; ++i) points.push_back(lattice_point());
      if (shape == Shape::displaced)
        for (auto& p : points)
          for (double* x : {&p.x, &p.y})
            if (random_.chance(0.4)) *x = moved(*x);
      break;
    case Shape::quarter:
      for (int i = 0; i < n; ++i) points.push_back(at(quarters(grid_.width()), quarters(grid_.height())));
      break;
    case Shape::uniform:
      for (int i = 0; i < n; ++i) points.push_back(anywhere(0.5));
      break;
    case Shape::sliver: {
      Point2d const a = random_.chance(0.5) ? lattice_point() : anywhere(0.5), b = anywhere(0.5);
      points = {a, b};
      for (int i = 2; i < n; ++i) {
        double const t = random_.uniform(-0.5, 1.5);
        points.push_back({moved(a.x + t * (b.x - a.x)), moved(a.y + t * (b.y - a.y))});
      }
      break;
    }
    case Shape::parallel: {
      Point2d const a = anywhere(1), b = anywhere(1), width = at_step(random_.uniform(-4, 4), random_.uniform(-4, 4));
      points = {a, b, {a.x + width.x, a.y + width.y}, {moved(b.x + width.x), moved(b.y + width.y)}};
      break;
    }
    case Shape::tiny: {
      Point2d const a = random_.chance(0.5) ? lattice_point() : anywhere(0);
      double const size = std::ldexp(1.0, -random_.between(0, 40));
      for (int i = 0; i < n; ++i) {
        Point2d const d = at_step(random_.uniform(-size, size), random_.uniform(-size, size));
        points.push_back({a.x + d.x, a.y + d.y});
      }
      break;
    }
    case Shape::large: {
      double const size = std::ldexp(1.0, random_.between(1, 20));
      for (int i = 0; i < n; ++i) points.push_back(at(random_.uniform(-size, size), random_.uniform(-size, size)));
      break;
    }
    case Shape::degenerate: {
      Point2d const a = at(quarters(grid_.width()), quarters(grid_.height()));
      points.assign(static_cast<std::size_t>(random_.between(1, 3)), a);
      if (random_.chance(0.7)) {
        int const du = random_.between(-9, 9), dv = random_.between(-9, 9);
        for (int k = random_.between(1, 3); k > 0; --k) {
          double const t = random_.between(-4, 4) * 0.25;
          points.push_back({a.x + t * du * grid_.step().x, a.y + t * dv * grid_.step().y});
        }
      }
      break;
    }
    case Shape::through_corner: {
      Point2d const a = lattice_point(), b = lattice_point();
      double s = random_.uniform(-3, 0), t = random_.uniform(1, 4);
      if (random_.chance(0.5)) {  // on a grid finer than doubles can follow where pixels are no short doubles
        s = std::round(s * 1024) / 1024;
        t = std::round(t * 1024) / 1024;
      }
      points = {{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)}, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}};
      for (int i = 2; i < n; ++i) points.push_back(anywhere(1));
      break;
    }
    }
    return points;
  }

private:
  Point2d at(double u, double v) const
  {
    return {grid_.origin().x + u * grid_.step().x, grid_.origin().y + v * grid_.step().y};
  }
  Point2d at_step(double u, double v) const { return {u * grid_.step().x, v * grid_.step().y}; }
  Point2d lattice_point()
  {
    return at(random_.between(-2, grid_.width() + 2), random_.between(-2, grid_.height() + 2));
  }
  double quarters(int n) { return 0.25 * random_.between(-8, 4 * n + 8); }
  Point2d anywhere(double beyond)
  {
    double const w = grid_.width(), h = grid_.height();
    return at(random_.uniform(-beyond * w, (1 + beyond) * w), random_.uniform(-beyond * h, (1 + beyond) * h));
  }
  double moved(double x)
  {
    int const way = random_.between(-1, 1);
    return way == 0 ? x : std::nextafter(x, way * HUGE_VAL);
  }

  Grid grid_;
  Random random_;
};

/// Rasters of all kinds of origin and pixel size. The first `short_grids` have lines that are short doubles.
inline std::vector<Grid> tested_grids()
{
  return {Grid::covering({0, 0}, {16, 12}, 16, 12),
          Grid::covering({-4, -3}, {4, 3}, 16, 12),
          Grid::covering({1e6, -1e6}, {1e6 + 17, -1e6 + 8}, 17, 16),
          Grid::covering({-0.3, 0.1}, {0.7, 2.3}, 13, 9),
          Grid::covering({1e6 + 0.1, 1e6 + 0.2}, {1e6 + 33.3, 1e6 + 7.7}, 11, 16),
          Grid::covering({-1e-9, -1e9}, {2e-9, 1e9}, 16, 16),
          Grid::covering({0, 0}, {11.2, 9.1}, 16, 13)};
}
inline constexpr std::size_t short_grids = 3;

}  // namespace visibility::test
