#pragma once

#include "visibility/scene/convex_bodies.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// The plans of objects of many bodies, as convex polygons: with the heights of its bounds each makes an upright prism
/// around the object, smaller than the box, for whoever looks from aslant. Objects of few bodies have none: there the
/// bodies themselves are at hand.
class ObjectOutlines {
public:
  /// Objects of more bodies have an outline.
  static constexpr std::size_t few_bodies = 64;

  explicit ObjectOutlines(ConvexBodies const& bodies);

  /// Corners of the convex hull of the plan of the object's vertices, exactly decided: bit for bit those of vertices
  /// (or of bounds of balls). One or two if the plan is a point or a segment; empty if the object has few bodies.
  std::span<Point2d const> of(std::uint32_t object) const
  {
    return std::span(corners_).subspan(first_[object], first_[object + 1] - first_[object]);
  }

private:
  std::vector<Point2d> corners_;
  std::vector<std::size_t> first_;  // per object, and one past the last
};

}  // namespace visibility
