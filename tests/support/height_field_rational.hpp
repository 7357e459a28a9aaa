#pragma once

#include "support/height_field_oracle.hpp"

#include <stdexcept>
#include <string>

/// Elementary geometry of columns in rationals; knows nothing of the search.
namespace visibility::oracle::rational {

inline Point2q plan(Point3d const& p) { return {RationalNumber(p.x), RationalNumber(p.y)}; }
inline Point2q plan(Point2d const& p) { return {RationalNumber(p.x), RationalNumber(p.y)}; }
inline Point2q plan(Point3q const& p) { return {p.x, p.y}; }

/// Positive iff r lies left of the line from p to q.
inline RationalNumber turn(Point2q const& p, Point2q const& q, Point2q const& r)
{
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

template <class P>
std::vector<Point2q> polygon(std::vector<P> const& corners)
{
  std::vector<Point2q> out;
  for (auto const& c : corners) out.push_back(plan(c));
  return out;
}

/// Whether the point lies in the polygon's interior. Requires: counterclockwise.
bool inside(std::vector<Point2q> const& convex, Point2q const& p);
/// The height of the column's top plane over any point of the plane.
RationalNumber height(Column const& column, Point2q const& p);
/// Whether the half-open segment [p, s) meets the closed column.
bool meets(Column const& column, Point3q const& p, Point3q const& s);

inline void require(bool condition, char const* what)
{
  if (!condition) throw std::invalid_argument(std::string("height field: ") + what);
}

}  // namespace visibility::oracle::rational
