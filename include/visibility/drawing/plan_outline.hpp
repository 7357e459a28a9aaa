#pragma once

#include "visibility/scene/scene.hpp"

#include <vector>

namespace visibility {

/// What an object covers in plan: the points that the rings wind around (nonzero rule) and the discs. Rings are open
/// (the first point is not repeated); one without area stands for something upright, seen edge on. Points are the
/// scene's, bit for bit.
struct PlanOutline {
  struct Disc {
    Point2d centre;
    double radius;
  };
  std::vector<std::vector<Point2d>> rings;
  std::vector<Disc> discs;
};

/// Boxes, balls and prisms as they are, polyhedra by their hull in plan, triangles by their union: edges that two of
/// them share from opposite sides are left out. Upright triangles are left out unless all are upright; then the hull of
/// all stands for them. Requires: the object has a primitive.
PlanOutline plan_outline(Scene const& scene, Object const& object);

}  // namespace visibility
