#include "visibility/raster/half_plane.hpp"

#include <algorithm>
#include <cmath>

namespace visibility {

namespace {

/// A rounded number and a bound of its error: 0 if no operation rounded.
struct Tracked {
  double value, error;
};

Tracked product(double a, double b)
{
  double const v = a * b;
  // Where the residue itself may underflow it counts as one unit.
  double const lost = std::fabs(v) < 0x1p-960 && a != 0 && b != 0 ? 0x1p-1074 : 0;
  return {v, std::fabs(std::fma(a, b, -v)) + lost};
}

Tracked sum(Tracked const& a, Tracked const& b)
{
  double const s = a.value + b.value, part = s - a.value;
  double const lost = (a.value - (s - part)) + (b.value - part);
  return {s, (std::fabs(lost) + a.error + b.error) * (1 + 0x1p-50)};
}

/// The number times 2^k, to the nearest integer.
struct Rounded {
  std::int64_t value;
  double error;
};

Rounded round_scaled(Tracked const& t, int k)
{
  double const scaled = std::ldexp(t.value, k), nearest = std::rint(scaled);
  double const underflow = nearest == 0 && t.value != 0 ? 0x1p-1000 : 0;
  return {static_cast<std::int64_t>(nearest),
          std::fabs(scaled - nearest) + std::ldexp(t.error, k) + underflow + (t.error > 0 ? 0x1p-1000 : 0)};
}

constexpr PixelHalfPlane no_pixel{0, 0, -1}, every_pixel{0, 0, 0};

}  // namespace

PixelHalfPlane pixels_of(Grid const& grid, HalfPlane const& h, Cover cover)
{
  bool const inside = cover == Cover::inside;
  auto const unknown = inside ? no_pixel : every_pixel;
  // In pixels: a' i + b' j + c', each with its error.
  Tracked const a = product(h.a, grid.step().x), b = product(h.b, grid.step().y),
                c = sum(sum(product(h.a, grid.origin().x), product(h.b, grid.origin().y)), {h.c, h.error});
  double const size = std::max(std::fabs(a.value), std::fabs(b.value));
  if (!std::isfinite(size) || !std::isfinite(c.value) || !std::isfinite(c.error)) return unknown;
  if (size == 0) {
    if (a.error != 0 || b.error != 0) return unknown;
    return (inside ? c.value >= c.error : c.value >= -c.error) ? every_pixel : no_pixel;
  }

  int exponent = 0;
  std::frexp(size, &exponent);
  int const k = 47 - exponent;
  Rounded const ra = round_scaled(a, k), rb = round_scaled(b, k);
  double const scaled = std::ldexp(c.value, k), whole = std::floor(scaled);
  double const error = (ra.error * grid.width() + rb.error * grid.height() + std::ldexp(c.error, k) +
                        (c.error > 0 || (scaled == 0 && c.value != 0) ? 0x1p-1000 : 0)) *
                       (1 + 0x1p-40);
  if (!(error < 0x1p60)) return unknown;
  constexpr std::int64_t limit = std::int64_t{1} << 62;
  // Beyond 2^62 the constant alone decides, whatever the error.
  if (std::fabs(scaled) >= 0x1p62) return {ra.value, rb.value, scaled > 0 ? limit : -limit};
  auto const margin = static_cast<std::int64_t>(std::ceil(error));
  std::int64_t const corner = inside
                                ? std::min<std::int64_t>(ra.value, 0) + std::min<std::int64_t>(rb.value, 0) - margin
                                : std::max<std::int64_t>(ra.value, 0) + std::max<std::int64_t>(rb.value, 0) + margin;
  return {ra.value, rb.value, std::clamp(static_cast<std::int64_t>(whole) + corner, -limit, limit)};
}

}  // namespace visibility
