#pragma once

#include "visibility/methods/exact_25d/crossed_edge.hpp"
#include "visibility/scene/exposed_parts.hpp"

#include <vector>

namespace visibility::exact_25d {

/// A segment on the top of a column, exposed just in front of it, where a column of another object begins that is
/// higher behind it. `left` and `right` are its ends as seen along sight lines from front to back.
struct SeamPart {
  Point3q left, right;
};

/// The exposed parts of a foot, lifted to the top of its column. Exact.
std::vector<SeamPart> foot_seams(HeightField const& field, CrossedEdge const& wall, Foot const& foot);

}  // namespace visibility::exact_25d
