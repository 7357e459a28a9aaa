#pragma once

#include "support/height_field_oracle.hpp"
#include "support/random.hpp"

#include <cmath>
#include <vector>

namespace visibility::test {

using oracle::Cell;
using oracle::Column;

inline Column box(std::uint32_t object, double x0, double y0, double x1, double y1, double top)
{
  return {{{x0, y0, top}, {x1, y0, top}, {x1, y1, top}, {x0, y1, top}}, object, {}};
}
inline Column triangle(std::uint32_t object, Point3d a, Point3d b, Point3d c) { return {{a, b, c}, object, {}}; }

struct HeightField {
  std::vector<Column> columns;
  std::size_t objects;
  Cell cell;
};

inline Cell const unit_cell{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0, 1};

/// Boxes on a small grid with few heights: they abut, overlap, coincide, nest and line up, some under the cell. The
/// first half stands near the cell and is high, the others are scattered and low: many are hidden.
inline HeightField grid_field(Random& random, int boxes, int reach)
{
  HeightField f{{}, std::size_t(boxes), {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 1, 3}};
  for (std::uint32_t i = 0; i < std::uint32_t(boxes);) {
    bool const near = int(i) < boxes / 2;
    int const far = near ? 4 : reach, w = random.between(1, near ? 7 : 2), d = random.between(1, near ? 7 : 2);
    int const x = random.between(-far, far), y = random.between(-far, far);
    bool const in_cell = x < 2 && x + w > 0 && y < 2 && y + d > 0;
    if (in_cell && random.chance(0.9)) continue;
    f.columns.push_back(box(i++, x, y, x + w, y + d, in_cell ? 0 : near ? random.between(2, 6) : random.between(0, 4)));
  }
  return f;
}

/// A turned box. Requires: nothing; its corners are rounded but convex.
inline Column turned_box(Random& random, std::uint32_t object, Point2d centre, double size, double top)
{
  double const a = random.uniform(0, 6.28), w = random.uniform(0.2, 1) * size, d = random.uniform(0.2, 1) * size;
  Column c{{}, object, {}};
  for (auto [u, v] : {std::pair{-w, -d}, {w, -d}, {w, d}, {-w, d}})
    c.corners.push_back(
      {centre.x + u * std::cos(a) - v * std::sin(a), centre.y + u * std::sin(a) + v * std::cos(a), top});
  return c;
}

/// A point of the ring between the two radii.
inline Point2d around(Random& random, double near, double far)
{
  double const a = random.uniform(0, 6.28), r = random.uniform(near, far);
  return {r * std::cos(a), r * std::sin(a)};
}

/// Boxes turned anyhow around a box-shaped cell, apart from it, crossing one another now and then; the first half near,
/// large and high, so that many of the others are hidden.
inline HeightField turned_field(Random& random, int boxes, double reach)
{
  HeightField f{{}, std::size_t(boxes), {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0, random.uniform(1, 3)}};
  for (std::uint32_t i = 0; i < std::uint32_t(boxes); ++i)
    f.columns.push_back(int(i) < boxes / 2
                          ? turned_box(random, i, around(random, 5, 7), 2.5, random.uniform(3, 8))
                          : turned_box(random, i, around(random, 7, reach), 1, random.uniform(0.5, 4)));
  return f;
}

/// Boxes and triangles with slanted tops.
inline HeightField slanted_field(Random& random, int columns, double reach)
{
  HeightField f = turned_field(random, columns, reach);
  for (auto& c : f.columns) {
    if (random.chance(0.3)) continue;
    c.corners.pop_back();
    for (auto& p : c.corners) p.z += random.uniform(-2, 2);
  }
  return f;
}

/// Slanted triangles with corners on a small grid.
inline HeightField slanted_grid_field(Random& random, int columns, int reach)
{
  HeightField f = grid_field(random, columns, reach);
  for (auto& c : f.columns) {
    bool const in_cell = c.corners[0].x < 2 && c.corners[2].x > 0 && c.corners[0].y < 2 && c.corners[2].y > 0;
    if (in_cell || random.chance(0.3)) continue;
    c.corners.erase(c.corners.begin() + random.below(4));
    for (auto& p : c.corners) p.z += random.between(-1, 1);
  }
  return f;
}

/// Slanted triangles in one place, crossing one another in plan and in height; on a grid or anywhere.
inline HeightField crossing_field(Random& random, int columns, bool on_grid)
{
  HeightField f{{}, std::size_t(columns), unit_cell};
  auto const point = [&] {
    if (on_grid)
      return Point3d{double(random.between(2, 8)), double(random.between(-3, 4)), double(random.between(0, 3))};
    return Point3d{random.uniform(2, 8), random.uniform(-3, 4), random.uniform(0.2, 3)};
  };
  while (f.columns.size() < std::size_t(columns)) {
    Point3d const a = point(), b = point(), c = point();
    if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.01)
      f.columns.push_back(triangle(std::uint32_t(f.columns.size()), a, b, c));
  }
  return f;
}

}  // namespace visibility::test
