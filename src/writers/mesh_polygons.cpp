#include "writers.hpp"

#include "visibility/scene/footprint.hpp"
#include "visibility/scene/scene_builder.hpp"

#include <algorithm>

namespace visibility::writers {

namespace {

using Polygon = std::vector<Point3d>;

void add_box(Box const& b, std::vector<Polygon>& faces)
{
  static constexpr int quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (auto const& q : quads) {
    Polygon face;
    for (int const corner : q) face.push_back(b.corner(corner));
    if (face[0] != face[1] && face[1] != face[2]) faces.push_back(std::move(face));  // a flat box has fewer faces
  }
}

bool is_clockwise(std::vector<Point2d> const& ring)
{
  double area = 0;  // the direction of walls is a courtesy, so rounding does no harm
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    area +=
      (ring[i].x - ring[0].x) * (ring[i + 1].y - ring[0].y) - (ring[i].y - ring[0].y) * (ring[i + 1].x - ring[0].x);
  return area < 0;
}

void add_prism(Prism const& p, Object const& object, std::vector<Polygon>& faces)
{
  auto const pieces = convex_partition(p);
  if (pieces.empty()) cannot_hold(object, "a footprint whose rings cross");
  for (auto const& piece : pieces) {
    Polygon roof, floor;
    for (auto const& v : piece.footprint) {
      roof.push_back({v.x, v.y, p.top});
      floor.push_back({v.x, v.y, p.bottom});
    }
    std::ranges::reverse(floor);
    faces.push_back(std::move(roof));
    faces.push_back(std::move(floor));
  }
  for (std::size_t r = 0; r < p.rings.size(); ++r) {
    auto ring = p.rings[r];
    if (is_clockwise(ring) == (r == 0)) std::ranges::reverse(ring);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      auto const &a = ring[i], &b = ring[(i + 1) % ring.size()];
      faces.push_back({{a.x, a.y, p.bottom}, {b.x, b.y, p.bottom}, {b.x, b.y, p.top}, {a.x, a.y, p.top}});
    }
  }
}

}  // namespace

std::vector<Polygon> solid_faces(Scene const& scene, Object const& object)
{
  if (object.balls.size() > 0) cannot_hold(object, "a ball");
  std::vector<Polygon> faces;
  for (auto i = object.boxes.first; i < object.boxes.last; ++i) add_box(scene.boxes[i], faces);
  for (auto i = object.prisms.first; i < object.prisms.last; ++i) add_prism(scene.prisms[i], object, faces);
  for (auto i = object.polyhedra.first; i < object.polyhedra.last; ++i) {
    auto const& p = scene.polyhedra[i];
    for (auto const& f : p.facets)
      faces.push_back({p.vertices[f.vertices[0]], p.vertices[f.vertices[1]], p.vertices[f.vertices[2]]});
  }
  return faces;
}

void cannot_hold(Object const& object, std::string const& what)
{
  throw BadInput("object '" + object.name + "': this file format cannot hold " + what +
                 "; write a .json scene instead");
}

}  // namespace visibility::writers
