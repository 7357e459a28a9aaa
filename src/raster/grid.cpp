#include "visibility/raster/grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace visibility {

namespace {

struct Axis {
  double origin, step;
};

/// Lines (n + i m) 2^e with |n| <= 2^51 and 0 <= i m <= 2^52 + 2^12: sums and products of these integers are doubles.
Axis cover(double low, double high, int count)
{
  double const extent = std::max(std::fabs(low), std::fabs(high));
  if (!(low < high) || !(extent <= Grid::max_extent))
    throw std::invalid_argument("Grid: not a rectangle in the domain");
  if (high - low < 0x1p-36 * extent) throw std::invalid_argument("Grid: a rectangle too narrow for its coordinates");
  int exponent = 0;
  std::frexp(extent, &exponent);
  int const e = exponent - 51;
  auto const n = static_cast<std::int64_t>(std::floor(std::ldexp(low, -e)));
  auto const end = static_cast<std::int64_t>(std::ceil(std::ldexp(high, -e)));
  std::int64_t const m = (end - n + count - 1) / count;
  double const step = std::ldexp(static_cast<double>(m), e);
  if (!(step >= Grid::min_step)) throw std::invalid_argument("Grid: pixels too small");
  return {std::ldexp(static_cast<double>(n), e), step};
}

}  // namespace

Grid Grid::covering(Point2d const& low, Point2d const& high, int width, int height)
{
  if (width < 1 || height < 1 || width > max_size || height > max_size)
    throw std::invalid_argument("Grid: width and height must be 1 to 4096 pixels");
  Axis const x = cover(low.x, high.x, width), y = cover(low.y, high.y, height);
  return {{x.origin, y.origin}, {x.step, y.step}, width, height};
}

}  // namespace visibility
