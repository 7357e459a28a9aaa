#pragma once

#include "visibility/geometry/segment_ball.hpp"
#include "visibility/geometry/segment_box.hpp"
#include "visibility/geometry/segment_polyhedron.hpp"
#include "visibility/geometry/segment_prism.hpp"
#include "visibility/geometry/segment_triangle.hpp"
#include "visibility/scene/scene.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// A scene as closed convex sets: each is an occluder on its own, and together the bodies of an object cover all its
/// faces. Boxes, balls and polyhedra are taken as they are, prisms through their convex partition, closed convex
/// pieces of a mesh as polyhedra, all other triangles one by one. Nothing is ever replaced by a hull.
class ConvexBodies {
public:
  enum class Kind : std::uint8_t { box, ball, prism, polyhedron, triangle };
  struct Body {
    std::uint32_t object;
    std::uint32_t index;  ///< into the array of its kind: the scene's boxes, balls, triangles, polyhedra; or our own
    Kind kind;
    bool occludes;  ///< false for bodies of objects that do not occlude, and for stand-ins
  };

  /// Keeps a reference to the scene, which must outlive this.
  explicit ConvexBodies(Scene const& scene);

  Scene const& scene() const { return *scene_; }
  std::span<Body const> bodies() const { return bodies_; }  ///< in object order
  std::span<Body const> bodies_of(std::uint32_t object) const;
  /// Position in bodies() of each object's first body, and the number of bodies at the end.
  std::span<std::uint32_t const> first_of_object() const { return first_body_; }
  std::span<Box const> bounds() const { return bounds_; }  ///< one per body, outward
  std::span<Box const> bounds_of(std::uint32_t object) const;
  std::size_t invalid_footprints() const { return invalid_footprints_; }  ///< occludees only

  /// Whether the body is the bounding box that stands for a prism with an invalid footprint; it does not occlude.
  bool is_stand_in(Body const& b) const { return b.kind == Kind::box && b.index >= scene_->boxes.size(); }
  Box const& box(Body const& b) const
  {
    return is_stand_in(b) ? stand_ins_[b.index - scene_->boxes.size()] : scene_->boxes[b.index];
  }
  Ball const& ball(Body const& b) const { return scene_->balls[b.index]; }
  ConvexPrism const& prism(Body const& b) const { return prisms_[b.index]; }
  ConvexPolyhedron const& polyhedron(Body const& b) const
  {
    return b.index < scene_->polyhedra.size() ? scene_->polyhedra[b.index]
                                              : mesh_pieces_[b.index - scene_->polyhedra.size()];
  }
  Triangle triangle(Body const& b) const { return scene_->triangle(b.index); }

  /// Points whose convex hull contains the body: its vertices; the corners of its bounding box for a ball.
  void append_vertices(Body const& b, std::vector<Point3d>& out) const;

private:
  void add(Body body, Box const& bounds);

  Scene const* scene_;
  std::vector<Body> bodies_;
  std::vector<Box> bounds_;
  std::vector<std::uint32_t> first_body_;  // per object, and one past the last
  std::vector<Box> stand_ins_;
  std::vector<ConvexPrism> prisms_;
  std::vector<ConvexPolyhedron> mesh_pieces_;
  std::size_t invalid_footprints_ = 0;
};

/// Calls f(shape) with the body's Box, Ball, ConvexPrism, ConvexPolyhedron or Triangle; returns what f does.
template <class F>
auto visit_shape(ConvexBodies const& scene, ConvexBodies::Body const& body, F&& f)
{
  using Kind = ConvexBodies::Kind;
  switch (body.kind) {
  case Kind::box: return f(scene.box(body));
  case Kind::ball: return f(scene.ball(body));
  case Kind::prism: return f(scene.prism(body));
  case Kind::polyhedron: return f(scene.polyhedron(body));
  case Kind::triangle: break;
  }
  return f(scene.triangle(body));
}

/// Whether the segment from p to q meets the closed body. Requires: p != q. Exact.
template <Arithmetic A, End end = End::included, class NT>
bool segment_meets(ConvexBodies const& scene, ConvexBodies::Body const& body, Point3<NT> const& p, Point3<NT> const& q)
{
  return visit_shape(scene, body, [&](auto const& shape) { return segment_meets<A, end>(shape, p, q); });
}

}  // namespace visibility
