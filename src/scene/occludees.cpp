#include "visibility/scene/occludees.hpp"

#include "upper_boundary.hpp"

#include "visibility/predicates/orient2d.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <array>

namespace visibility {

Occludees::Occludees(PreparedScene const& scene) : scene_(&scene)
{
  Scene const& s = scene.scene();
  if (!s.balls.empty()) throw BadInput("occludees of a 2.5D query cannot be balls");
  for (std::uint32_t o = 0; o < s.objects.size(); ++o) {
    auto const& object = s.objects[o];
    for (auto i = object.boxes.first; i < object.boxes.last; ++i) add(o, s.boxes[i]);
    for (auto i = object.prisms.first; i < object.prisms.last; ++i) add(o, s.prisms[i]);
    for (auto i = object.polyhedra.first; i < object.polyhedra.last; ++i) add(o, s.polyhedra[i]);
    for (auto i = object.triangles.first; i < object.triangles.last; ++i) {
      auto const [a, b, c] = s.triangle(i).vertices;
      add_triangle(o, a, b, c);
    }
  }
  hierarchy_ = BoundingHierarchy(bounds_);
}

void Occludees::add(std::uint32_t object, Box const& b)
{
  std::array const top{Point3d{b.min.x, b.min.y, b.max.z}, Point3d{b.max.x, b.min.y, b.max.z},
                       Point3d{b.max.x, b.max.y, b.max.z}, Point3d{b.min.x, b.max.y, b.max.z}};
  if (b.min.x < b.max.x && b.min.y < b.max.y) add_top(object, top);
  for (std::size_t i = 0; i < 4; ++i)
    add_wall(object, horizontal(top[i]), horizontal(top[(i + 1) % 4]), b.min.z, b.max.z);
}

void Occludees::add(std::uint32_t object, Prism const& prism)
{
  std::vector<Point3d> corners;
  for (auto const& piece : convex_partition(prism)) {
    corners.clear();
    for (auto const& p : piece.footprint) corners.push_back({p.x, p.y, piece.top});
    add_top(object, corners);
  }
  for (auto const& ring : prism.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      add_wall(object, ring[i], ring[(i + 1) % ring.size()], prism.bottom, prism.top);
}

void Occludees::add(std::uint32_t object, ConvexPolyhedron const& polyhedron)
{
  for (auto const& f : polyhedron.facets) {
    auto const &a = polyhedron.vertices[f.vertices[0]], &b = polyhedron.vertices[f.vertices[1]],
               &c = polyhedron.vertices[f.vertices[2]];
    if (!is_negative(orient2d<Filtered>(horizontal(a), horizontal(b), horizontal(c)))) add_triangle(object, a, b, c);
  }
}

void Occludees::add_triangle(std::uint32_t object, Point3d const& a, Point3d const& b, Point3d const& c)
{
  switch (orient2d<Filtered>(horizontal(a), horizontal(b), horizontal(c))) {
  case Sign::positive: add_top(object, std::array{a, b, c}); return;
  case Sign::negative: add_top(object, std::array{a, c, b}); return;
  case Sign::zero: break;
  }
  auto const upright = [&](auto const coordinate) {
    return orient2d<Filtered>(Point2d{coordinate(a), a.z}, Point2d{coordinate(b), b.z}, Point2d{coordinate(c), c.z});
  };
  if (is_zero(upright([](Point3d const& p) { return p.x; })) && is_zero(upright([](Point3d const& p) { return p.y; })))
    return;
  std::vector<Point3d> points{a, b, c};
  auto const boundary = visibility::upper_boundary({a, b, c});
  points.insert(points.end(), boundary.begin(), boundary.end());
  add_piece({0, 3, static_cast<std::uint32_t>(boundary.size()), object}, points);
}

void Occludees::add_top(std::uint32_t object, std::span<Point3d const> corners)
{
  add_piece({0, static_cast<std::uint32_t>(corners.size()), 0, object}, corners);
}

void Occludees::add_wall(std::uint32_t object, Point2d const& a, Point2d const& b, double bottom, double top)
{
  if (a == b || !(bottom < top)) return;
  Point3d const high_a{a.x, a.y, top}, high_b{b.x, b.y, top};
  add_piece({0, 4, 2, object},
            std::array{Point3d{a.x, a.y, bottom}, Point3d{b.x, b.y, bottom}, high_b, high_a, high_a, high_b});
}

void Occludees::add_piece(Piece piece, std::span<Point3d const> points)
{
  piece.first = static_cast<std::uint32_t>(points_.size());
  points_.insert(points_.end(), points.begin(), points.end());
  pieces_.push_back(piece);
  Box box;
  for (auto const& p : points) box.extend(p);
  bounds_.push_back(box);
}

}  // namespace visibility
