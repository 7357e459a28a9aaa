#pragma once

#include "support/random_scenes.hpp"

#include "visibility/scene/height_field.hpp"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

/// Scenes for the tests of height fields, and the truth about a column at a rational point.
namespace visibility::test {

using Ring = std::vector<Point2d>;

/// One object: anything but balls.
struct Shape {
  std::vector<Box> boxes;
  std::vector<Prism> prisms;
  std::vector<ConvexPolyhedron> polyhedra;
  std::vector<Triangle> triangles;
};
inline Shape box(double x0, double y0, double x1, double y1, double top, double bottom = 0)
{
  return {{Box{{x0, y0, bottom}, {x1, y1, top}}}, {}, {}, {}};
}
inline Triangle triangle(Point3d const& a, Point3d const& b, Point3d const& c) { return {{a, b, c}}; }
inline Shape mesh(std::vector<Triangle> triangles) { return {{}, {}, {}, std::move(triangles)}; }
inline Shape prism(std::vector<Ring> rings, double top) { return {{}, {Prism{std::move(rings), 0, top}}, {}, {}}; }

/// Objects named "0", "1", ...
inline Scene scene_of(std::vector<Shape> const& shapes)
{
  SceneBuilder builder("test");
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    builder.begin_object(std::to_string(i));
    for (auto const& b : shapes[i].boxes) builder.add(b);
    for (auto const& p : shapes[i].prisms) builder.add(p);
    for (auto const& p : shapes[i].polyhedra) builder.add(p);
    for (auto const& t : shapes[i].triangles) {
      auto const first = builder.add_vertex(t.vertices[0]);
      builder.add_vertex(t.vertices[1]);
      builder.add_vertex(t.vertices[2]);
      builder.add_triangle(first, first + 1, first + 2);
    }
  }
  return builder.finish();
}

/// Objects of all kinds on the grid {0, 2, ..., 2n}^2, heights in {1, ..., 4}: they abut, overlap, nest and coincide.
inline std::vector<Shape> random_shapes(Random& random, int count, int n)
{
  auto const point = [&] {
    return Point3d{2.0 * random.between(0, n), 2.0 * random.between(0, n), double(random.between(1, 4))};
  };
  std::vector<Shape> shapes;
  for (int i = 0; i < count; ++i) {
    Box b = grid_box(random, 0, n);
    b = {{2 * b.min.x, 2 * b.min.y, 0}, {2 * b.max.x, 2 * b.max.y, double(random.between(1, 4))}};
    switch (random.below(6)) {
    case 0: shapes.push_back({{b}, {}, {}, {}}); break;
    case 1: {
      double const x = (b.min.x + b.max.x) / 2, y = (b.min.y + b.max.y) / 2;
      shapes.push_back(
        prism({{{b.min.x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, b.max.y}, {x, y}, {b.min.x, b.max.y}}}, b.max.z));
      break;
    }
    case 2: shapes.push_back({{}, {}, {grid_polyhedron(random, 1, 2 * n)}, {}}); break;
    case 3: {  // vertical, sometimes a line
      Point3d const p = point(), q = point(), r = random.chance(0.5) ? p : q;
      shapes.push_back(mesh({triangle(p, q, {r.x, r.y, double(random.between(0, 4))})}));
      break;
    }
    default: {  // triangles that share an edge, in plan on either side of it or on the same, sometimes one below others
      Point3d const p = point(), q = point();
      shapes.push_back(mesh({triangle(p, q, point()), triangle(q, p, point())}));
      for (int k = random.below(3); k > 0; --k) {
        double const low = random.between(0, 1);
        shapes.back().triangles.push_back(triangle({p.x, p.y, p.z - low}, {q.x, q.y, q.z - random.below(2)}, point()));
      }
    }
    }
  }
  return shapes;
}

/// Height of the plane through the column's top over a point, by Cramer's rule.
inline RationalNumber top_over(HeightField const& field, HeightField::Column const& column, Point2q const& p)
{
  using NT = RationalNumber;
  auto const c = field.corners(column);
  for (std::size_t i = 2; i < c.size(); ++i) {
    auto const a = exact(c[0]), b = exact(c[i - 1]), d = exact(c[i]);
    NT const area = (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x);
    if (area == 0) continue;
    NT const s = ((p.x - a.x) * (d.y - a.y) - (p.y - a.y) * (d.x - a.x)) / area;
    NT const t = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / area;
    return a.z + s * (b.z - a.z) + t * (d.z - a.z);
  }
  throw std::logic_error("a column without area");
}

/// Whether the closed polygon contains the point.
inline bool contains(HeightField const& field, HeightField::Column const& column, Point2q const& p)
{
  auto const c = field.corners(column);
  for (std::size_t i = 0; i < c.size(); ++i) {
    auto const a = exact(c[i]), b = exact(c[(i + 1) % c.size()]);
    if ((b.x - a.x) * (p.y - a.y) < (b.y - a.y) * (p.x - a.x)) return false;
  }
  return true;
}

/// Height of the upper surface over a point; empty where there is none. Curtains do not count.
inline std::optional<RationalNumber> surface_over(HeightField const& field, Point2q const& p)
{
  std::optional<RationalNumber> highest;
  for (auto const& c : field.columns())
    if (!c.is_curtain() && contains(field, c, p))
      if (auto const z = top_over(field, c, p); !highest || *highest < z) highest = z;
  return highest;
}

/// Position of the edge a -> b of an object.
inline std::uint32_t edge_at(HeightField const& field, std::uint32_t object, Point3d const& a, Point3d const& b)
{
  for (std::uint32_t i = 0; i < field.edges().size(); ++i) {
    auto const& e = field.edges()[i];
    if (field.object_of(e) == object && e.a == a && e.b == b) return i;
  }
  throw std::logic_error("no such edge");
}

}  // namespace visibility::test
