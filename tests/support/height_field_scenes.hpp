#pragma once

#include "support/height_field_oracle.hpp"
#include "support/random.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/scene/height_field.hpp"
#include "visibility/scene/scene_builder.hpp"
#include "visibility/scene/view_cell.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace visibility::test {

/// Named recipes of small 2.5D scenes around a cell, all with ground 0.
enum class HeightScene {
  general,       ///< boxes anywhere, nothing equal
  grid,          ///< boxes on an integer grid: abutting, overlapping, coincident, equal heights
  streets,       ///< rows of boxes that share walls along streets, few heights
  slanted,       ///< columns under triangles in general position
  slanted_grid,  ///< columns under triangles with integer corners: shared and crossing edges
  far_detail,    ///< the grid of `grid`, in millimetres, near 10^6
  one_ulp        ///< `streets` with corners and heights moved by an ulp
};
inline constexpr HeightScene height_scenes[] = {
  HeightScene::general,      HeightScene::grid,       HeightScene::streets, HeightScene::slanted,
  HeightScene::slanted_grid, HeightScene::far_detail, HeightScene::one_ulp};

struct HeightCase {
  Scene scene;
  std::vector<Point3d> cell;  ///< corners of an upright prism
};

namespace detail {

struct BoxMaker {
  Random& random;
  bool grid;
  double number(int lo, int hi) { return grid ? double(random.between(lo, hi)) : random.uniform(lo, hi); }
  Box operator()()
  {
    for (;;) {
      double const x = number(-9, 7), y = number(-9, 7), w = number(1, 6), d = number(1, 6);
      Box const b{{x, y, 0}, {x + w, y + d, number(1, 6)}};
      // Out of the way of the cell, mostly; what is under it must stay below its top.
      bool const near = b.min.x < 1 && b.max.x > -1 && b.min.y < 1 && b.max.y > -1;
      if (!near || (random.chance(0.1) && b.max.z < 2)) return b;
    }
  }
};

inline double jolt(Random& random, double x)
{
  switch (random.below(4)) {
  case 0: return std::nextafter(x, HUGE_VAL);
  case 1: return std::nextafter(x, -HUGE_VAL);
  default: return x;
  }
}

}  // namespace detail

/// `objects` columns about an upright cell near the origin.
inline HeightCase height_case(Random& random, HeightScene kind, int objects)
{
  SceneBuilder builder("test");
  bool const grid = kind == HeightScene::grid || kind == HeightScene::far_detail;
  detail::BoxMaker box{random, grid};
  auto const place = [&](Point3d p) {
    if (kind == HeightScene::far_detail) return Point3d{1e6 + p.x * 0.001, 2e6 + p.y * 0.001, p.z * 0.001};
    if (kind == HeightScene::one_ulp)
      return Point3d{detail::jolt(random, p.x), detail::jolt(random, p.y), p.z > 0 ? detail::jolt(random, p.z) : p.z};
    return p;
  };
  auto const triangle = [&](bool on_grid) {
    for (;;) {
      auto const number = [&](int lo, int hi) {
        return on_grid ? double(random.between(lo, hi)) : random.uniform(lo, hi);
      };
      double const x = number(-8, 8), y = number(-8, 8);
      std::array<Point3d, 3> t;
      for (auto& c : t) c = {x + number(-3, 3), y + number(-3, 3), number(1, 6)};
      Sign const turn = orient2d<Filtered>(horizontal(t[0]), horizontal(t[1]), horizontal(t[2]));
      bool const near =
        std::ranges::any_of(t, [](Point3d const& c) { return std::fabs(c.x) < 4 && std::fabs(c.y) < 4; });
      if (is_zero(turn) || near) continue;
      return t;
    }
  };
  for (int i = 0; i < objects; ++i) {
    builder.begin_object("object " + std::to_string(i));
    if (kind == HeightScene::slanted || kind == HeightScene::slanted_grid) {
      auto const t = triangle(kind == HeightScene::slanted_grid);
      std::array<std::uint32_t, 3> top{}, base{};
      for (std::size_t k = 0; k < 3; ++k) {
        top[k] = builder.add_vertex(t[k]);
        base[k] = builder.add_vertex({t[k].x, t[k].y, 0});
      }
      builder.add_triangle(top[0], top[1], top[2]);
      for (std::size_t k = 0, l = 1; k < 3; ++k, l = (l + 1) % 3) {
        builder.add_triangle(base[k], base[l], top[l]);
        builder.add_triangle(base[k], top[l], top[k]);
      }
      continue;
    }
    Box b = box();
    if (kind == HeightScene::streets || kind == HeightScene::one_ulp) {
      // Lots of 2 x 2 with streets of width 1 between every other row, some doubled.
      int const column = random.between(-3, 3), row = random.between(-2, 2);
      double const x = column * 2.0, y = row < 0 ? row * 3.0 - 1 : row * 3.0 + 1;
      b = {{x, y, 0}, {x + 2, y + 2, double(random.between(1, 4))}};
    }
    Point3d const low = place(b.min), high = place(b.max);
    builder.add(Box{{low.x, low.y, 0}, high});
  }
  HeightCase out{builder.finish(), {}};
  std::vector<Point2d> footprint;
  if (random.chance(0.5))
    footprint = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  else
    footprint = {{-1, -0.5}, {0.25, -1}, {1, 0.5}, {-0.5, 1}};
  double const bottom = 0.5, top = kind == HeightScene::general ? random.uniform(0.6, 3)
                                   : random.chance(0.6)         ? 1.0
                                                                : double(random.between(1, 4));
  for (auto const& p : footprint)
    for (double const z : {bottom, top}) {
      Point3d q{p.x, p.y, z};
      if (kind == HeightScene::far_detail) q = {1e6 + q.x * 0.001, 2e6 + q.y * 0.001, q.z * 0.001};
      out.cell.push_back(q);
    }
  return out;
}

inline std::vector<oracle::Column> oracle_columns(visibility::HeightField const& field)
{
  std::vector<oracle::Column> out;
  for (auto const& c : field.columns()) {
    auto const corners = field.corners(c);
    if (!c.is_curtain()) out.push_back({{corners.begin(), corners.end()}, c.object, {}});
  }
  return out;
}

/// Requires: corners in pairs of bottom and top, counterclockwise.
inline oracle::Cell oracle_cell(std::vector<Point3d> const& corners)
{
  oracle::Cell cell{{}, corners[0].z, corners[1].z};
  for (std::size_t i = 0; i < corners.size(); i += 2) cell.footprint.push_back(horizontal(corners[i]));
  return cell;
}

}  // namespace visibility::test
