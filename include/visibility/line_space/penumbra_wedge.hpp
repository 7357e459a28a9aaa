#pragma once

#include "visibility/kernel/bounded.hpp"
#include "visibility/line_space/funnel.hpp"
#include "visibility/line_space/portal_sequence.hpp"
#include "visibility/predicates/orient3d.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>

namespace visibility {

/// A double with a proved bound on its distance from the exact value (infinite or NaN after an overflow).
struct Enclosed {
  double value, error;
};

namespace detail {

template <bounded::Number T>
Enclosed enclosed(T const& x)
{
  return {x.v, bounded::relative_bound<T::roundings> * x.magnitude()};
}

inline Enclosed enclosed_orient2d(Point2d const& p, Point2d const& q, Point2d const& r)
{
  using bounded::Input;
  return enclosed(Orient2dFormula{}(Input{p.x}, Input{p.y}, Input{q.x}, Input{q.y}, Input{r.x}, Input{r.y}));
}

inline Enclosed enclosed_orient3d(Point3d const& p, Point3d const& q, Point3d const& r, Point3d const& s)
{
  using bounded::Input;
  return enclosed(Orient3dFormula{}(Input{p.x}, Input{p.y}, Input{p.z}, Input{q.x}, Input{q.y}, Input{q.z}, Input{r.x},
                                    Input{r.y}, Input{r.z}, Input{s.x}, Input{s.y}, Input{s.z}));
}

}  // namespace detail

/// A closed range of positions on an edge, from its left end (0) to its right end (1).
struct EdgeRange {
  double low = 0, high = 1;
};

/// The positions at which the lines of a funnel cross an edge; rounded outward. A position is a fraction of linear
/// functions of the line, so that its extremes over a convex polygon of lines are at vertices.
/// Requires: all lines of the funnel pass between the ends.
inline EdgeRange crossed_range(Funnel const& lines, PlanGate const& e)
{
  constexpr double out = 1 + 0x1p-50;
  EdgeRange range{1, 0};
  for (auto const& v : lines.vertices()) {
    Enclosed const l = detail::enclosed_orient2d(v.p, v.q, e.left), r = detail::enclosed_orient2d(v.p, v.q, e.right);
    double const error = l.error + r.error, width = l.value - r.value;
    if (!(width > 4 * error)) return {};
    range.low = std::min(range.low, (l.value - error) / (width + error) / out);
    range.high = std::max(range.high, (l.value + error) / (width - error) * out);
  }
  return {std::max(0.0, range.low), std::min(1.0, range.high)};
}

/// The four shadow planes of an occluder edge under a source edge, as seen along a target edge: how far the line from
/// an end of the source to an end of the target passes above the occluder, as a volume (orient3d). For positions
/// between the ends the volume is bilinear, so its extremes over ranges of positions are those at the four corners. The
/// wedge between the highest and the lowest is the penumbra of [Bittner05, §5.3]; proofs/exact_2_5d.md.
template <Arithmetic A>
class PenumbraWedge {
public:
  PenumbraWedge(PortalSequence::Edge const& source, PortalSequence::Edge const& target,
                PortalSequence::Edge const& occluder)
    : source_(source), target_(target), occluder_(occluder)
  {
    double largest = 0;
    for (int i = 0; i < 4; ++i) {
      Enclosed const e = detail::enclosed_orient3d(source_end(i), target_end(i), occluder.right, occluder.left);
      volume_[static_cast<std::size_t>(i)] = e.value;
      error_ = std::max(error_, e.error);
      largest = std::max(largest, std::fabs(e.value));
      undefined_ |= !(e.error < infinity);
    }
    error_ = A::is_exact ? error_ + 0x1p-48 * largest : 0;  // of the interpolation below: a few roundings
  }

  /// No line from the source to the target within the ranges passes strictly above the occluder. May be false although
  /// it is so; never true although it is not (unless `Double`).
  bool certainly_hides(EdgeRange const& s, EdgeRange const& t) const
  {
    if constexpr (!std::same_as<A, Rational>) {
      if (undefined_) return exactly_hides();
      double const highest = extreme(s, t, [](double a, double b) { return std::max(a, b); });
      if (highest < -error_) return true;
      if (highest > error_) return false;
    }
    return exactly_hides();
  }

  /// Every line from the source to the target within the ranges passes above the occluder, or touches it.
  bool certainly_above(EdgeRange const& s, EdgeRange const& t) const
  {
    if (undefined_) return false;
    return extreme(s, t, [](double a, double b) { return std::min(a, b); }) > error_;
  }

  /// Approximate height of the line above the occluder, as a volume.
  double at(double s, double t) const
  {
    return (1 - s) * ((1 - t) * volume_[0] + t * volume_[2]) + s * ((1 - t) * volume_[1] + t * volume_[3]);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Point3d const& source_end(int i) const { return (i & 1) == 0 ? source_.left : source_.right; }
  Point3d const& target_end(int i) const { return (i & 2) == 0 ? target_.left : target_.right; }

  template <class Extreme>
  double extreme(EdgeRange const& s, EdgeRange const& t, Extreme pick) const
  {
    return pick(pick(at(s.low, t.low), at(s.low, t.high)), pick(at(s.high, t.low), at(s.high, t.high)));
  }

  bool exactly_hides() const
  {
    for (int i = 0; i < 4; ++i)
      if (is_positive(orient3d<A>(source_end(i), target_end(i), occluder_.right, occluder_.left))) return false;
    return true;
  }

  PortalSequence::Edge const &source_, &target_, &occluder_;
  std::array<double, 4> volume_{};
  double error_ = 0;
  bool undefined_ = false;
};

}  // namespace visibility
