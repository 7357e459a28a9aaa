#include "plan.hpp"

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/predicates/orient2d.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace visibility::detail::plan {

double area(Polygon const& polygon)
{
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += turn(polygon[0], polygon[i], polygon[i + 1]);
  return sum / 2;
}

double perimeter(Polygon const& polygon)
{
  double sum = 0;
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) sum += distance(polygon[i], polygon[(i + 1) % n]);
  return sum;
}

Point2d mean(Polygon const& polygon)
{
  Point2d sum{0, 0};
  for (auto const& p : polygon) sum = {sum.x + p.x, sum.y + p.y};
  double const n = static_cast<double>(polygon.size());
  return {sum.x / n, sum.y / n};
}

double left_of(Point2d const& a, Point2d const& b, Point2d const& p) { return turn(a, b, p) / distance(a, b); }

Polygon clip(Polygon const& convex, Point2d const& a, Point2d const& b)
{
  Polygon out;
  for (std::size_t i = 0, n = convex.size(); i < n; ++i) {
    Point2d const &p = convex[i], &q = convex[(i + 1) % n];
    double const fp = turn(a, b, p), fq = turn(a, b, q);
    if (fp >= 0) out.push_back(p);
    if ((fp > 0 && fq < 0) || (fp < 0 && fq > 0)) {
      double const t = fp / (fp - fq);
      Point2d x{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
      if (a.x == b.x) x.x = a.x;
      if (a.y == b.y) x.y = a.y;
      out.push_back(x);
    }
  }
  return out;
}

bool enters(Polygon const& convex, Point2d const& p, Point2d const& q, double slack)
{
  double first = 0, last = 1;
  for (std::size_t i = 0, n = convex.size(); i < n; ++i) {
    Point2d const &a = convex[i], &b = convex[(i + 1) % n];
    if (a == b) continue;
    double const fp = left_of(a, b, p) - slack, fq = left_of(a, b, q) - slack;
    if (fp <= 0 && fq <= 0) return false;
    if (fp < 0) first = std::max(first, fp / (fp - fq));
    if (fq < 0) last = std::min(last, fp / (fp - fq));
  }
  return first < last;
}

bool contains(Polygon const& convex, Polygon const& inner, double slack)
{
  for (std::size_t i = 0, n = convex.size(); i < n; ++i) {
    Point2d const &a = convex[i], &b = convex[(i + 1) % n];
    if (a == b) continue;
    if (std::ranges::any_of(inner, [&](Point2d const& p) { return left_of(a, b, p) < -slack; })) return false;
  }
  return true;
}

Polygon shrunk(Polygon const& polygon, double by)
{
  Polygon out = polygon;
  Point2d const c = mean(polygon);
  for (auto& p : out) p = {p.x + by * (c.x - p.x), p.y + by * (c.y - p.y)};
  return out;
}

Polygon convex_hull(Polygon points)
{
  std::ranges::sort(points, {}, [](Point2d const& p) { return std::tuple(p.x, p.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  std::size_t start = 0;
  auto const extend = [&](Point2d const& p) {  // Andrew's monotone chain
    while (hull.size() >= start + 2 && !is_positive(orient2d<Filtered>(hull[hull.size() - 2], hull.back(), p)))
      hull.pop_back();
    hull.push_back(p);
  };
  for (auto const& p : points) extend(p);
  start = hull.size() - 1;
  for (auto i = points.rbegin() + 1; i != points.rend(); ++i) extend(*i);
  hull.pop_back();
  return hull;
}

Polygon with_few_corners(Polygon convex, std::size_t most)
{
  while (convex.size() > std::max<std::size_t>(most, 3)) {
    std::size_t const n = convex.size();
    std::size_t least = 0;
    double least_loss = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i)
      if (double const loss = turn(convex[(i + n - 1) % n], convex[i], convex[(i + 1) % n]); loss < least_loss)
        least = i, least_loss = loss;
    convex.erase(convex.begin() + static_cast<std::ptrdiff_t>(least));
  }
  return convex;
}

Polygon without_straight_corners(Polygon const& polygon, double slack)
{
  Polygon out = polygon;
  for (std::size_t i = 0; i < out.size() && out.size() > 3;) {
    std::size_t const n = out.size();
    Point2d const &a = out[(i + n - 1) % n], &b = out[(i + 1) % n];
    bool const straight = a == b || distance(a, out[i]) <= slack || std::abs(left_of(a, b, out[i])) <= slack;
    if (straight)
      out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return out;
}

}  // namespace visibility::detail::plan
