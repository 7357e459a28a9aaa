#include "visibility/raster/fixed_points.hpp"

#include "int128.hpp"

#include <algorithm>
#include <cmath>

namespace visibility::detail {

namespace {

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
  all.clear();
  double reach = std::max(error.x / step.x, error.y / step.y);
  if (!(reach < 0x1p46)) return false;
  pixels.clear();
  for (auto const& p : input) {
    auto const& [u, v] = pixels.emplace_back(in_pixels(p.x, origin.x, step.x), in_pixels(p.y, origin.y, step.y));
    if (!(std::fabs(u.value) < 0x1p46 && std::fabs(v.value) < 0x1p46)) return false;
    reach = std::max({reach, std::fabs(u.value), std::fabs(v.value)});
  }

  int exponent = 0;
  std::frexp(reach, &exponent);
  fraction = std::min(max_fraction, coordinate_bits - exponent);
  double const scale = std::ldexp(1.0, fraction);
  for (auto const& [u, v] : pixels) {
    double const fixed_u = nearest_integer(u.value * scale), fixed_v = nearest_integer(v.value * scale);
    points.push_back({static_cast<std::int64_t>(fixed_u), static_cast<std::int64_t>(fixed_v),
                      static_cast<std::int8_t>(!u.is_exact || fixed_u != u.value * scale),
                      static_cast<std::int8_t>(!v.is_exact || fixed_v != v.value * scale)});
  }
  error_u = error_units(error.x, step.x, scale);
  error_v = error_units(error.y, step.y, scale);
  return true;
}

void FixedPoints::reduce_to_hull()
{
  auto const same_errors = [&](FixedPoint const& p) {
    return p.off_u == points.front().off_u && p.off_v == points.front().off_v;
  };
  if (!std::all_of(points.begin(), points.end(), same_errors)) all = points;
  std::sort(points.begin(), points.end());
  auto const same_place = [](FixedPoint const& p, FixedPoint const& q) { return p.u == q.u && p.v == q.v; };
  points.erase(std::unique(points.begin(), points.end(), same_place), points.end());
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

PixelBox FixedPoints::outer_bounds() const
{
  constexpr std::int64_t far = std::int64_t{1} << 62;
  PixelBox box{far, far, -far, -far};
  for (auto const& p : all.empty() ? points : all)
    box = {std::min(box.u0, p.u - p.off_u), std::min(box.v0, p.v - p.off_v), std::max(box.u1, p.u + p.off_u),
           std::max(box.v1, p.v + p.off_v)};
  return {box.u0 - error_u, box.v0 - error_v, box.u1 + error_u, box.v1 + error_v};
}

PixelBox FixedPoints::inner_bounds() const
{
  PixelBox box{points[0].u, points[0].v, points[0].u, points[0].v};
  for (auto const& p : points)
    box = {std::min(box.u0, p.u), std::min(box.v0, p.v), std::max(box.u1, p.u), std::max(box.v1, p.v)};
  // Of the points on a bound, the one that may be farthest from it counts.
  PixelBox off{0, 0, 0, 0};
  for (auto const& p : points) {
    if (p.u == box.u0) off.u0 = std::max<std::int64_t>(off.u0, p.off_u);
    if (p.v == box.v0) off.v0 = std::max<std::int64_t>(off.v0, p.off_v);
    if (p.u == box.u1) off.u1 = std::max<std::int64_t>(off.u1, p.off_u);
    if (p.v == box.v1) off.v1 = std::max<std::int64_t>(off.v1, p.off_v);
  }
  return {box.u0 + error_u + off.u0, box.v0 + error_v + off.v0, box.u1 - error_u - off.u1, box.v1 - error_v - off.v1};
}

PixelHalfPlane left_of(FixedPoint const& p, FixedPoint const& q, FixedPoints const& fixed, EdgeCover cover)
{
  std::int64_t const a = p.v - q.v, b = q.u - p.u, size_a = std::abs(a), size_b = std::abs(b);
  // Left of the line: a u + b v + c >= 0. In pixels, i = u / 2^fraction: a i + b j + c / 2^fraction >= 0, where only
  // the constant is not an integer, so that rounding it down (strictly: up, less one) changes nothing.
  Int128 const c = -(product(a, p.u) + product(b, p.v));
  Int128 margin = product(size_a, fixed.error_u + std::max(p.off_u, q.off_u)) +
                  product(size_b, fixed.error_v + std::max(p.off_v, q.off_v));
  if (cover == EdgeCover::touching || cover == EdgeCover::pair_interior_touching)
    for (auto const& r : fixed.all)  // a point near the edge may be less exact than its ends
      margin = std::max(margin, product(size_a, fixed.error_u + r.off_u) + product(size_b, fixed.error_v + r.off_v) -
                                  (product(a, r.u) + product(b, r.v) + c));
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
