#pragma once

#include "visibility/scene/scene.hpp"

#include <array>
#include <vector>

namespace visibility::height_field {

/// The columns of one object after another; buffers are reused.
class ObjectColumns {
public:
  struct Edge {
    Point3d a, b;
    std::uint32_t column;  ///< position among the object's columns
  };
  struct Result {
    std::vector<std::vector<Point3d>> columns;  ///< corners, counterclockwise; two for a curtain
    std::vector<Edge> edges;
    std::vector<std::array<Point3d, 3>> walls;  ///< vertical triangles
    std::size_t solids = 0;                     ///< columns of boxes and prisms: they come first
    std::size_t invalid_footprints = 0;
  };

  explicit ObjectColumns(Scene const& scene) : scene_(scene) {}
  Result const& of(Object const& object);

private:
  struct Side {
    Point3d a, b;  ///< lexicographically ordered in plan
    bool forward;  ///< the column lies to the left of a -> b
    std::uint32_t column;
  };

  void add(Prism const& prism);
  void add(ConvexPolyhedron const& polyhedron);
  void add_triangle(Point3d const& a, Point3d const& b, Point3d const& c);
  void add_curtain(Point3d const& a, Point3d const& b);
  void find_edges();
  void drop_idle_curtains();
  bool is_curtain(Side const& s) const { return result_.columns[s.column].size() == 2; }
  bool is_covered(std::vector<Side> const& group, Side const& side) const;
  bool is_redundant(std::vector<Side> const& group, Side const& side) const;

  Scene const& scene_;
  Result result_;
};

}  // namespace visibility::height_field
