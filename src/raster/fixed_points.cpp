#include "visibility/raster/fixed_points.hpp"

#include "int128.hpp"

#include <algorithm>
#include <cmath>

namespace visibility::detail {

namespace {

struct PixelCoordinate {
  double value;
  bool is_exact;
};

/// (x - origin) / step, rounded, and whether it is exact: the difference by its error term, the quotient by its
/// residue.
PixelCoordinate in_pixels(double x, double origin, double step)
{
  double const d = x - origin, part = d - x;
  double const lost = (x - (d - part)) - (origin + part);
  double const q = d / step;
  return {q, lost == 0 && std::fma(q, step, -d) == 0};
}

/// The nearest integer of |x| <= 2^51, ties to even.
double nearest_integer(double x)
{
  constexpr double shift = 0x1.8p52;
  return (x + shift) - shift;
}

/// The caller's error in fixed units, rounded up.
std::int64_t error_units(double error, double step, double scale)
{
  return error == 0 ? 0 : static_cast<std::int64_t>(std::ceil(error / step * scale * (1 + 0x1p-40) + 0x1p-1000));
}

/// Sign of the turn p, q, r; differences are below 2^49.
bool turns_left(FixedPoint const& p, FixedPoint const& q, FixedPoint const& r)
{
  return product(q.u - p.u, r.v - p.v) > product(q.v - p.v, r.u - p.u);
}

/// One chain of the hull: keeps strict left turns on top of `kept`.
void add_to_chain(std::vector<FixedPoint>& chain, std::size_t start, FixedPoint const& p)
{
  while (chain.size() >= start + 2 && !turns_left(chain[chain.size() - 2], chain.back(), p)) chain.pop_back();
  chain.push_back(p);
}

}  // namespace

bool FixedPoints::assign(std::span<Point2d const> input, Point2d const& origin, Point2d const& step,
                         Point2d const& error)
{
  points.clear();
  double reach = std::max(error.x / step.x, error.y / step.y);
  if (!(reach < 0x1p46)) return false;
  for (auto const& p : input) {
    double const u = std::fabs((p.x - origin.x) / step.x), v = std::fabs((p.y - origin.y) / step.y);
    if (!(u < 0x1p46 && v < 0x1p46)) return false;
    reach = std::max({reach, u, v});
  }

  int exponent = 0;
  std::frexp(reach, &exponent);
  fraction = std::min(max_fraction, coordinate_bits - exponent);
  double const scale = std::ldexp(1.0, fraction);
  bool exact_u = true, exact_v = true;
  for (auto const& p : input) {
    auto const u = in_pixels(p.x, origin.x, step.x), v = in_pixels(p.y, origin.y, step.y);
    double const fixed_u = nearest_integer(u.value * scale), fixed_v = nearest_integer(v.value * scale);
    exact_u &= u.is_exact && fixed_u == u.value * scale;
    exact_v &= v.is_exact && fixed_v == v.value * scale;
    points.push_back({static_cast<std::int64_t>(fixed_u), static_cast<std::int64_t>(fixed_v)});
  }
  error_u = error_units(error.x, step.x, scale) + (exact_u ? 0 : 1);
  error_v = error_units(error.y, step.y, scale) + (exact_v ? 0 : 1);
  return true;
}

void FixedPoints::reduce_to_hull()
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::size_t const n = points.size();
  if (n < 2) return;
  // Andrew's monotone chains, built behind the sorted points and moved to the front.
  points.reserve(3 * n + 1);
  for (std::size_t i = 0; i < n; ++i) add_to_chain(points, n, points[i]);
  std::size_t const upper = points.size() - 1;
  for (std::size_t i = n - 1; i-- > 0;) add_to_chain(points, upper, points[i]);
  points.pop_back();  // the first point again
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n));
}

FixedPoint FixedPoints::low() const
{
  FixedPoint m = points.front();
  for (auto const& p : points) m = {std::min(m.u, p.u), std::min(m.v, p.v)};
  return {m.u - error_u, m.v - error_v};
}

FixedPoint FixedPoints::high() const
{
  FixedPoint m = points.front();
  for (auto const& p : points) m = {std::max(m.u, p.u), std::max(m.v, p.v)};
  return {m.u + error_u, m.v + error_v};
}

PixelHalfPlane left_of(FixedPoint const& p, FixedPoint const& q, FixedPoints const& fixed, EdgeCover cover)
{
  std::int64_t const a = p.v - q.v, b = q.u - p.u, size_a = std::abs(a), size_b = std::abs(b);
  // Left of the line: a u + b v + c >= 0. In pixels, i = u / 2^fraction: a i + b j + c / 2^fraction >= 0, where only
  // the constant is not an integer, so that rounding it down (strictly: up, less one) changes nothing.
  Int128 const c = -(product(a, p.u) + product(b, p.v));
  Int128 const margin = product(size_a, fixed.error_u) + product(size_b, fixed.error_v);
  Int128 k = 0;
  switch (cover) {
  case EdgeCover::inside:
    k = ((c - margin) >> fixed.fraction) + std::min<std::int64_t>(a, 0) + std::min<std::int64_t>(b, 0);
    break;
  case EdgeCover::touching:
    k = ((c + margin) >> fixed.fraction) + std::max<std::int64_t>(a, 0) + std::max<std::int64_t>(b, 0);
    break;
  case EdgeCover::interior_touching:
    k = -(-(c + margin) >> fixed.fraction) - 1 + std::max<std::int64_t>(a, 0) + std::max<std::int64_t>(b, 0);
    break;
  case EdgeCover::pair_interior_touching: k = -(-(c + margin) >> fixed.fraction) - 1 + size_a + size_b; break;
  }
  // Beyond 2^62 the constant alone decides: |a i + b j| <= 2^61 in any raster.
  constexpr Int128 limit = Int128{1} << 62;
  return {a, b, static_cast<std::int64_t>(std::clamp(k, -limit, limit))};
}

}  // namespace visibility::detail
