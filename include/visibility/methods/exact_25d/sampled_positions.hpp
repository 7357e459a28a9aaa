#pragma once

#include "visibility/line_space/funnel.hpp"
#include "visibility/line_space/portal_sequence.hpp"

#include <boost/container/small_vector.hpp>

#include <cmath>

namespace visibility::exact_25d {

/// Where a line crosses source and target, each from its left end (0) to its right end (1).
struct SampledPosition {
  double source, target;
};

/// A few lines of a funnel, in floating point: in its middle and near each corner of its polygon of lines, where the
/// clearance is greatest. Those that do not cross the source are left out.
inline boost::container::small_vector<SampledPosition, 8> sampled_positions(Funnel const& lines,
                                                                            PortalSequence::Edge const& source,
                                                                            PortalSequence::Edge const& target)
{
  // The lines as homogeneous vectors of equal size, by the sides of the four ends.
  struct Sides {
    double source_left, source_right, target_left, target_right;
  };
  boost::container::small_vector<Sides, 8> sides;
  for (auto const& v : lines.vertices()) {
    double const dx = v.q.x - v.p.x, dy = v.q.y - v.p.y, size = std::hypot(dx, dy);
    auto const side = [&](Point3d const& x) { return (dx * (x.y - v.p.y) - dy * (x.x - v.p.x)) / size; };
    sides.push_back({side(source.left), side(source.right), side(target.left), side(target.right)});
  }
  boost::container::small_vector<SampledPosition, 8> out;
  for (std::size_t j = 0; j <= sides.size(); ++j) {
    Sides sum{0, 0, 0, 0};
    for (std::size_t i = 0; i < sides.size(); ++i) {
      double const w = (i + 1 == j ? 8.0 : 1.0) + 0.1 * static_cast<double>(i);
      sum = {sum.source_left + w * sides[i].source_left, sum.source_right + w * sides[i].source_right,
             sum.target_left + w * sides[i].target_left, sum.target_right + w * sides[i].target_right};
    }
    double const s = sum.source_left / (sum.source_left - sum.source_right);
    double const t = sum.target_left / (sum.target_left - sum.target_right);
    if (s > 0 && s < 1) out.push_back({s, t});
  }
  return out;
}

}  // namespace visibility::exact_25d
