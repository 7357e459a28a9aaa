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

/// How far lines from a source to a target pass above an edge, as volumes at the four pairs of ends, each with an error
/// of at most `error`. In between it is bilinear, so extremes over ranges of positions are those at their corners.
struct WedgeVolumes {
  std::array<double, 4> volume{};  ///< left-left, right-left, left-right, right-right: source, then target
  double error = 0;                ///< infinite or NaN: nothing is known

  double at(double s, double t) const
  {
    return (1 - s) * ((1 - t) * volume[0] + t * volume[2]) + s * ((1 - t) * volume[1] + t * volume[3]);
  }
  double highest(EdgeRange const& s, EdgeRange const& t) const
  {
    return std::max(std::max(at(s.low, t.low), at(s.low, t.high)), std::max(at(s.high, t.low), at(s.high, t.high)));
  }
  double lowest(EdgeRange const& s, EdgeRange const& t) const
  {
    return std::min(std::min(at(s.low, t.low), at(s.low, t.high)), std::min(at(s.high, t.low), at(s.high, t.high)));
  }
  /// No line within the ranges passes above the edge; certain.
  bool clearly_hides(EdgeRange const& s, EdgeRange const& t) const { return highest(s, t) < -error; }
  /// Every line within the ranges does; certain.
  bool certainly_above(EdgeRange const& s, EdgeRange const& t) const { return lowest(s, t) > error; }
  /// Makes room for the few roundings of the interpolation.
  void widen()
  {
    double largest = 0;
    for (double const v : volume) largest = std::max(largest, std::fabs(v));
    error += 0x1p-48 * largest;
  }
};

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
    for (int i = 0; i < 4; ++i) {
      Enclosed const e = detail::enclosed_orient3d(source_end(i), target_end(i), occluder.right, occluder.left);
      volumes_.volume[static_cast<std::size_t>(i)] = e.value;
      volumes_.error = std::max(volumes_.error, std::isfinite(e.error) ? e.error : HUGE_VAL);
    }
    volumes_.widen();
    if (!A::is_exact) volumes_.error = 0;
  }

  /// No line from the source to the target within the ranges passes strictly above the occluder. May be false although
  /// it is so; never true although it is not (unless `Double`).
  bool certainly_hides(EdgeRange const& s, EdgeRange const& t) const
  {
    if constexpr (!std::same_as<A, Rational>) {
      double const highest = volumes_.highest(s, t);
      if (highest < -volumes_.error) return true;
      if (highest > volumes_.error) return false;
    }
    return exactly_hides();
  }

  bool clearly_hides(EdgeRange const& s, EdgeRange const& t) const { return volumes_.clearly_hides(s, t); }
  bool certainly_above(EdgeRange const& s, EdgeRange const& t) const { return volumes_.certainly_above(s, t); }
  /// Approximate height of the line above the occluder, as a volume.
  double at(double s, double t) const { return volumes_.at(s, t); }

private:
  Point3d const& source_end(int i) const { return (i & 1) == 0 ? source_.left : source_.right; }
  Point3d const& target_end(int i) const { return (i & 2) == 0 ? target_.left : target_.right; }

  bool exactly_hides() const
  {
    for (int i = 0; i < 4; ++i)
      if (is_positive(orient3d<A>(source_end(i), target_end(i), occluder_.right, occluder_.left))) return false;
    return true;
  }

  PortalSequence::Edge const &source_, &target_, &occluder_;
  WedgeVolumes volumes_;
};

/// Whether the wedges together hide all positions in the ranges: each part of a division into at most 4^depth has one
/// that hides it. The wedges must share source and target. May be false although they do.
template <class Wedges>
bool hide_together(Wedges const& wedges, EdgeRange const& s, EdgeRange const& t, int depth)
{
  if (std::ranges::any_of(wedges, [&](auto const& w) { return w.clearly_hides(s, t); })) return true;
  if (depth == 0 || std::ranges::all_of(wedges, [&](auto const& w) { return w.certainly_above(s, t); })) return false;
  double const middle_s = s.low / 2 + s.high / 2, middle_t = t.low / 2 + t.high / 2;
  for (EdgeRange const& half_s : {EdgeRange{s.low, middle_s}, EdgeRange{middle_s, s.high}})
    for (EdgeRange const& half_t : {EdgeRange{t.low, middle_t}, EdgeRange{middle_t, t.high}})
      if (!hide_together(wedges, half_s, half_t, depth - 1)) return false;
  return true;
}

}  // namespace visibility
