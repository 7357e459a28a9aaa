#pragma once

#include "line_clip.hpp"
#include "polygon_sides.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

/// What is exposed inside a convex polygon, counterclockwise in plan.
namespace visibility::height_field {

/// Whether a segment has length in the interior of the polygon.
inline bool enters(Corners polygon, Point2q const& p, Point2q const& q)
{
  LineRange range{RationalNumber(0), RationalNumber(1)};
  range.clip(polygon, p, q);
  if (!range.has_length()) return false;
  RationalNumber const t = (*range.low + *range.high) / 2;
  Point2q const middle{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  return !any_side(polygon, [&](Point3d const& c, Point3d const& d) {
    return turn(horizontal(exact(c)), horizontal(exact(d)), middle) <= 0;
  });
}

/// The part of a convex polygon inside another one, in plan.
inline std::vector<Point2q> intersection(Corners a, Corners b)
{
  std::vector<Point2q> part, kept;
  for (auto const& c : a) part.push_back(horizontal(exact(c)));
  any_side(b, [&](Point3d const& c, Point3d const& d) {
    Point2q const p = horizontal(exact(c)), q = horizontal(exact(d));
    kept.clear();
    for (std::size_t i = 0; i < part.size(); ++i) {
      Point2q const &x = part[i], &y = part[i + 1 < part.size() ? i + 1 : 0];
      RationalNumber const at_x = turn(p, q, x), at_y = turn(p, q, y);
      if (at_x >= 0) kept.push_back(x);
      if ((at_x > 0 && at_y < 0) || (at_x < 0 && at_y > 0)) {
        RationalNumber const t = at_x / (at_x - at_y);
        kept.push_back({x.x + t * (y.x - x.x), x.y + t * (y.y - x.y)});
      }
    }
    std::swap(part, kept);
    return false;
  });
  return part;
}

enum class At : std::uint8_t { covered, open, undecided };

/// What `look_at` says of a point of the polygon, the first that it can decide. Requires: the polygon has area, and the
/// answer is the same at nearly all points of it.
template <class LookAt>
bool is_open_inside(std::vector<Point2q> const& polygon, LookAt const& look_at)
{
  using NT = RationalNumber;
  // Points on a curve that meets a line in few places.
  for (int k = 1;; ++k) {
    Point2q sum{0, 0};
    NT total = 0, weight = 1;
    for (auto const& p : polygon) {
      sum = {sum.x + weight * p.x, sum.y + weight * p.y};
      total += weight;
      weight *= NT(k) + NT(1) / NT(2);
    }
    At const at = look_at(Point2q{sum.x / total, sum.y / total});
    if (at != At::undecided) return at == At::open;
  }
}

}  // namespace visibility::height_field
