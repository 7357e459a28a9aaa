#pragma once

#include "support/random.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <string_view>
#include <vector>

/// Named recipes for point tuples, from harmless to vicious. Every predicate is tested on all of them, and the tests
/// assert that the degenerate ones reach the layer that they are meant for.
namespace visibility::test {

enum class Recipe {
  uniform,      ///< coordinates uniform in [-1000, 1000)
  log_uniform,  ///< any finite exponent, independently for each coordinate
  grid,         ///< small integers: axis-aligned, shared, equal heights
  collinear,    ///< exactly on one line, with enough bits that products round
  coplanar,     ///< exactly in one plane, with enough bits that products round
  rounded,      ///< on a plane up to rounding
  nextafter,    ///< coplanar, then some coordinates moved by one unit in the last place
  coincident,   ///< few distinct points
  subnormal,    ///< coplanar or collinear, a few million times the smallest subnormal
  huge,         ///< coplanar or collinear near the overflow threshold: differences and products overflow
  city          ///< millimetres near 10^6, on rotated walls and at shared heights
};

inline constexpr std::array all_recipes{Recipe::uniform,   Recipe::log_uniform, Recipe::grid,      Recipe::collinear,
                                        Recipe::coplanar,  Recipe::rounded,     Recipe::nextafter, Recipe::coincident,
                                        Recipe::subnormal, Recipe::huge,        Recipe::city};

inline std::string_view name(Recipe recipe)
{
  static constexpr std::array<std::string_view, all_recipes.size()> names{
    "uniform",   "log_uniform", "grid",      "collinear", "coplanar", "rounded",
    "nextafter", "coincident",  "subnormal", "huge",      "city"};
  return names[static_cast<std::size_t>(recipe)];
}

/// Makes tuples of points by one recipe.
class PointSource {
public:
  PointSource(Recipe recipe, std::uint64_t seed) : recipe_(recipe), random_(seed) {}

  Random& random() { return random_; }

  template <std::size_t N>
  std::array<Point3d, N> tuple()
  {
    std::array<Point3d, N> points;
    begin_tuple();
    for (auto& p : points) p = next();
    if (recipe_ == Recipe::coincident)
      for (auto& p : points)
        if (random_.chance(0.5)) p = points[static_cast<std::size_t>(random_.below(static_cast<int>(N)))];
    return points;
  }

private:
  double finite_bits()
  {
    for (;;) {
      double const x = std::bit_cast<double>(random_.bits());
      if (std::isfinite(x)) return x;
    }
  }

  Point3d integer_point(int bits)
  {
    int const r = (1 << bits) - 1;
    return {double(random_.between(-r, r)), double(random_.between(-r, r)), double(random_.between(-r, r))};
  }

  /// Fixes what the points of one tuple share: a line or plane with integer origin and directions, and a scale.
  void begin_tuple()
  {
    flat_ = recipe_ != Recipe::collinear && (recipe_ == Recipe::coplanar || random_.chance(0.6));
    bool const small = recipe_ == Recipe::subnormal || recipe_ == Recipe::huge;
    origin_ = integer_point(small ? 18 : 27);
    u_ = integer_point(small ? 9 : 24);
    v_ = integer_point(small ? 9 : 24);
    if (random_.chance(0.2)) v_ = {0, 0, 1024};
    scale_ = recipe_ == Recipe::subnormal ? 0x1p-1074
             : recipe_ == Recipe::huge    ? std::ldexp(1.0, 1023 - random_.between(20, 60))
                                          : 1.0;
  }

  Point3d on_lattice(double i, double j) const
  {
    auto const at = [&](double o, double u, double v) { return (o + i * u + j * v) * scale_; };
    return {at(origin_.x, u_.x, v_.x), at(origin_.y, u_.y, v_.y), at(origin_.z, u_.z, v_.z)};
  }

  Point3d next()
  {
    switch (recipe_) {
    case Recipe::uniform: return random_.point(-1000, 1000);
    case Recipe::log_uniform: return {finite_bits(), finite_bits(), finite_bits()};
    case Recipe::grid: return random_.grid_point(0, 4);
    case Recipe::rounded: {
      double const i = random_.uniform(-1, 1), j = random_.uniform(-1, 1);
      return {0.1 + i * 0.7 - j * 0.3, -0.2 + i * 0.4 + j * 0.9, 12.3 - i * 0.6 + j * 0.1};
    }
    case Recipe::coincident: return random_.point(-1, 1);
    case Recipe::city: {
      double const t = 0.25 * random_.between(0, 100), height = random_.chance(0.7)
                                                                  ? 0.001 * random_.between(0, 3) * 3500
                                                                  : 0.001 * random_.between(0, 99999);
      double const x = 954321.007 + 0.8 * t, y = 1843210.111 + 0.6 * t;
      return {std::round(x * 1000) / 1000, std::round(y * 1000) / 1000, height};
    }
    default: break;
    }
    int const reach = recipe_ == Recipe::subnormal || recipe_ == Recipe::huge ? 9 : 6;
    Point3d p =
      on_lattice(random_.between(-(1 << reach), 1 << reach), flat_ ? random_.between(-(1 << reach), 1 << reach) : 0);
    if (recipe_ == Recipe::nextafter)
      for (double* x : {&p.x, &p.y, &p.z})
        if (random_.chance(0.3)) *x = std::nextafter(*x, random_.chance(0.5) ? HUGE_VAL : -HUGE_VAL);
    return p;
  }

  Recipe recipe_;
  Random random_;
  Point3d origin_{}, u_{}, v_{};
  double scale_ = 1;
  bool flat_ = false;
};

}  // namespace visibility::test
