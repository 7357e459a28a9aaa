#pragma once

#include "visibility/line_space/penumbra_wedge.hpp"
#include "visibility/methods/exact_25d/crossed_edge.hpp"
#include "visibility/scene/exposed_parts.hpp"

#include <algorithm>
#include <vector>

namespace visibility::exact_25d {

/// A top edge that is looked for, as sight lines cross it in one direction: the wall below it, or the top of its column
/// in front of it; only where no other column covers that. Positions run from the left end (0) to the right end (1).
class Target {
public:
  Target(HeightField const& field, CrossedEdge const& crossed) : crossed_(crossed), edge_(portal(field, crossed))
  {
    auto exposed = exposed_parts(field, crossed.edge, crossed.from_left ? Crossing::leaving : Crossing::entering);
    all_ = exposed.all;
    parts_ = std::move(exposed.parts);
    if (crossed.from_left) {  // the ends are exchanged
      std::ranges::reverse(parts_);
      for (auto& p : parts_) p = {RationalNumber(1) - p.high, RationalNumber(1) - p.low};
    }
    for (auto const& p : parts_) bounds_.push_back({CGAL::to_interval(p.low).first, CGAL::to_interval(p.high).second});
  }

  CrossedEdge const& crossed() const { return crossed_; }
  PortalSequence::Edge const& edge() const { return edge_; }
  bool is_fully_exposed() const { return all_; }
  bool is_covered() const { return !all_ && parts_.empty(); }
  std::vector<OpenInterval> const& parts() const { return parts_; }  ///< empty if fully exposed
  /// Holds all exposed parts. Requires: not covered.
  EdgeRange exposed_range() const { return all_ ? EdgeRange{} : EdgeRange{bounds_.front().low, bounds_.back().high}; }

  bool may_be_exposed(double t) const
  {
    return all_ ? 0 < t && t < 1
                : std::ranges::any_of(bounds_, [&](EdgeRange const& b) { return b.low < t && t < b.high; });
  }

  /// Whether the line through p and q crosses the edge in an exposed part. Requires: it crosses the edge. Exact.
  bool is_exposed(Point3d const& p, Point3d const& q) const
  {
    if (all_) return true;
    RationalNumber const t = position(p, q);
    return std::ranges::any_of(parts_, [&](OpenInterval const& i) { return i.low < t && t < i.high; });
  }

  /// Where the line through p and q crosses the edge in plan, as a point on the edge. Requires: it crosses it.
  Point3q crossing(Point3d const& p, Point3d const& q) const
  {
    return between(exact(edge_.left), exact(edge_.right), position(p, q));
  }

  /// The point of the edge in plan.
  Point2q point(RationalNumber const& t) const { return horizontal(between(exact(edge_.left), exact(edge_.right), t)); }

private:
  RationalNumber position(Point3d const& p, Point3d const& q) const
  {
    using R = RationalNumber;
    auto const side = [&](Point3d const& x) {
      return R(visibility::detail::Orient2dFormula{}(R(p.x), R(p.y), R(q.x), R(q.y), R(x.x), R(x.y)));
    };
    R const left = side(edge_.left);
    return left / (left - side(edge_.right));
  }

  CrossedEdge crossed_;
  PortalSequence::Edge edge_;
  bool all_ = true;
  std::vector<OpenInterval> parts_;
  std::vector<EdgeRange> bounds_;  // of the parts, rounded outward
};

}  // namespace visibility::exact_25d
