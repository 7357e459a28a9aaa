#pragma once

#include "support/random.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <vector>

namespace visibility::test {

/// A box with corners on the grid {lo, ..., hi}^3 and interior.
inline Box grid_box(Random& random, int lo, int hi)
{
  for (;;) {
    Box b;
    b.extend(random.grid_point(lo, hi));
    b.extend(random.grid_point(lo, hi));
    if (b.has_interior()) return b;
  }
}

/// A random convex polyhedron: the hull of grid points.
inline ConvexPolyhedron grid_polyhedron(Random& random, int lo, int hi)
{
  for (;;) {
    std::vector<Point3d> points;
    int const x = random.between(lo, hi - 2), y = random.between(lo, hi - 2), z = random.between(lo, hi - 2);
    for (int i = 0; i < 8; ++i)
      points.push_back({double(x + random.below(3)), double(y + random.below(3)), double(z + random.below(3))});
    try {
      return ConvexPolyhedron::hull(points);
    } catch (std::invalid_argument const&) {
      continue;  // all in one plane
    }
  }
}

/// Which primitives a random scene is made of.
enum class Mix { boxes, all };

/// Objects on a small grid, so that they touch, abut, coincide, nest and line up; every kind of primitive in turn.
/// Boxes and prisms keep out of the interior of `clear`.
inline Scene grid_scene(Random& random, int objects, int lo, int hi, Mix mix, Box const& clear = {})
{
  auto const box = [&] {
    for (;;) {
      Box const b = grid_box(random, lo, hi);
      bool const overlaps = b.min.x < clear.max.x && clear.min.x < b.max.x && b.min.y < clear.max.y &&
                            clear.min.y < b.max.y && b.min.z < clear.max.z && clear.min.z < b.max.z;
      if (!overlaps) return b;
    }
  };
  SceneBuilder builder("test");
  for (int i = 0; i < objects; ++i) {
    builder.begin_object("object " + std::to_string(i));
    Box const b = box();
    switch (mix == Mix::boxes ? 0 : random.below(5)) {
    case 0: builder.add(b); break;
    case 1: builder.add(Ball{random.grid_point(lo, hi), double(random.between(0, 2))}); break;
    case 2: {
      double const x = (b.min.x + b.max.x) / 2, y = (b.min.y + b.max.y) / 2;
      builder.add(Prism{
        {{{b.min.x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, b.max.y}, {x, y}, {b.min.x, b.max.y}}}, b.min.z, b.max.z});
      break;
    }
    case 3: builder.add(grid_polyhedron(random, lo, hi)); break;
    case 4: {
      auto const first = builder.add_vertex(random.grid_point(lo, hi));
      builder.add_vertex(random.grid_point(lo, hi));
      builder.add_vertex(random.grid_point(lo, hi));
      builder.add_triangle(first, first + 1, first + 2);
      break;
    }
    }
  }
  return builder.finish();
}

}  // namespace visibility::test
