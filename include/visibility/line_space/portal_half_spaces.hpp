#pragma once

#include "visibility/line_space/portal_sequence.hpp"
#include "visibility/line_space/stabbing_line.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace visibility {

/// Coordinates in which the numbers of one sequence are small: (x - origin) 2^-exponent per axis. Exact, and free to
/// choose: affine maps with positive determinant keep all sides.
struct PortalFrame {
  std::array<double, 3> origin{0, 0, 0};
  std::array<int, 3> exponent{0, 0, 0};
};

namespace detail {

/// Calls f(axis, coordinate) for all coordinates of the sequence.
template <class F>
void for_each_coordinate(PortalSequence const& sequence, F&& f)
{
  auto const point = [&](Point3d const& p) { f(0, p.x), f(1, p.y), f(2, p.z); };
  auto const edge = [&](PortalSequence::Edge const& e) { point(e.left), point(e.right); };
  edge(sequence.source);
  edge(sequence.target);
  for (auto const& e : sequence.occluders) edge(e);
  for (auto const& p : sequence.points) f(0, p.point.x), f(1, p.point.y);
}

/// The exponent of the lowest bit of x that is set. Requires: x finite, not zero.
inline int lowest_bit(double x)
{
  int exponent = 0;
  auto const mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  return exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(mantissa));
}

}  // namespace detail

/// The frame in which all coordinates are integers and the source edge starts at the origin; an axis whose numbers are
/// so far apart that a double cannot hold the largest scaled keeps its scale.
inline PortalFrame integer_frame(PortalSequence const& sequence)
{
  PortalFrame frame{{sequence.source.left.x, sequence.source.left.y, sequence.source.left.z}, {}};
  std::array<int, 3> low{4096, 4096, 4096}, high{-4096, -4096, -4096};
  detail::for_each_coordinate(sequence, [&](std::size_t axis, double x) {
    if (x == 0) return;
    low[axis] = std::min(low[axis], detail::lowest_bit(x));
    high[axis] = std::max(high[axis], std::ilogb(x));
  });
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (high[axis] >= low[axis] && high[axis] - low[axis] < 1000) frame.exponent[axis] = low[axis];
  return frame;
}

/// The oriented lines h such that a sight line l of the sequence is one with b(l, h) > 0 for all of them: verticals
/// through the points first (they span three dimensions, so the cone stays small), then source, target, occluders.
/// Up through a point on the left, down through one on the right; from left to right along an edge above the sight
/// line, from right to left along one below it.
template <class NT>
std::vector<PluckerLine<NT>> portal_half_spaces(PortalSequence const& sequence, PortalFrame const& frame = {})
{
  auto const coordinate = [&](std::size_t axis, double x) -> NT {
    int const e = -frame.exponent[axis];
    return NT(std::ldexp(x, e)) - NT(std::ldexp(frame.origin[axis], e));
  };
  auto const point = [&](Point3d const& p) {
    return Point3<NT>{coordinate(0, p.x), coordinate(1, p.y), coordinate(2, p.z)};
  };
  std::vector<PluckerLine<NT>> lines;
  lines.reserve(sequence.points.size() + sequence.occluders.size() + 2);
  for (auto const& [p, side] : sequence.points) {
    auto const upward = vertical_line(Point2<NT>{coordinate(0, p.x), coordinate(1, p.y)});
    lines.push_back(side == PortalSequence::Side::left ? upward : reversed(upward));
  }
  lines.push_back(line_through(point(sequence.source.left), point(sequence.source.right)));
  lines.push_back(line_through(point(sequence.target.left), point(sequence.target.right)));
  for (auto const& f : sequence.occluders) lines.push_back(line_through(point(f.right), point(f.left)));
  return lines;
}

/// Whether the sequence has a sight line, by the five-dimensional cone. Exact for exact NT.
template <class NT = ExactNumber>
bool has_sight_line(PortalSequence const& sequence)
{
  auto const lines = portal_half_spaces<NT>(sequence, integer_frame(sequence));
  return has_strict_stabbing_line(std::span<PluckerLine<NT> const>(lines), SearchDepth::edges);
}

/// A sight line of the sequence as two points of it, in its direction, if there is one: strictly below source and
/// target, strictly above the occluders, strictly between the points. Exact.
template <class NT = ExactNumber>
std::optional<std::array<Point3q, 2>> find_sight_line(PortalSequence const& sequence)
{
  PortalFrame const frame = integer_frame(sequence);
  auto const lines = portal_half_spaces<NT>(sequence, frame);
  auto const line = strict_stabbing_line(std::span<PluckerLine<NT> const>(lines), SearchDepth::edges);
  if (!line) return {};
  auto const [p, q] = two_points(rational(*line));
  auto const outside = [&](Point3q const& r) {
    auto const coordinate = [&](std::size_t axis, RationalNumber const& x) -> RationalNumber {
      // In two steps: 2^exponent alone can leave the range of doubles.
      int const half = frame.exponent[axis] / 2;
      return x * RationalNumber(std::ldexp(1.0, half)) * RationalNumber(std::ldexp(1.0, frame.exponent[axis] - half)) +
             RationalNumber(frame.origin[axis]);
    };
    return Point3q{coordinate(0, r.x), coordinate(1, r.y), coordinate(2, r.z)};
  };
  return std::array{outside(p), outside(q)};
}

}  // namespace visibility
