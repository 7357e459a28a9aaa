#pragma once

#include "visibility/kernel/point.hpp"

#include <optional>
#include <span>
#include <utility>

namespace visibility::height_field {

/// Twice the area of the triangle; positive: r lies to the left of p -> q.
inline RationalNumber turn(Point2q const& p, Point2q const& q, Point2q const& r)
{
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// What remains of a line's parameters t while it is clipped; an end that is not set is at infinity.
struct LineRange {
  using NT = RationalNumber;
  std::optional<NT> low{}, high{};
  bool is_empty = false;

  /// Keeps where the linear function with these values at t = 0 and t = 1 is not negative.
  void clip(NT const& at_0, NT const& at_1)
  {
    if (at_0 == at_1) {
      is_empty |= at_0 < 0;
      return;
    }
    NT t = at_0 / (at_0 - at_1);
    if (at_0 < at_1) {
      if (!low || *low < t) low = std::move(t);
    } else {
      if (!high || t < *high) high = std::move(t);
    }
  }
  /// Keeps what lies in the closed polygon, counterclockwise in plan, of the line that is at p for t = 0, at q for 1.
  void clip(std::span<Point3d const> polygon, Point2q const& p, Point2q const& q)
  {
    for (std::size_t i = polygon.size() - 1, j = 0; j < polygon.size() && !is_empty; i = j++) {
      Point2q const c = horizontal(exact(polygon[i])), d = horizontal(exact(polygon[j]));
      clip(turn(c, d, p), turn(c, d, q));
    }
  }
  bool has_length() const { return !is_empty && !(low && high && *low >= *high); }
};

}  // namespace visibility::height_field
