#include "visibility/raster/affine_depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace visibility {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double reach = 0x1p126;  // depths stay in the range of float
constexpr double u = 0x1p-53;      // unit roundoff

}  // namespace

PixelDepth PixelDepth::farther(double margin) const
{
  PixelDepth d = *this;
  d.base_ += margin;
  return d;
}

PixelDepth PixelDepth::above(Grid const& grid, AffineDepth const& z)
{
  PixelDepth d;
  double const x = z.slope.x * (grid.origin().x - z.at.x), y = z.slope.y * (grid.origin().y - z.at.y);
  d.slope_ = {z.slope.x * grid.step().x, z.slope.y * grid.step().y};
  d.magnitude_ = std::fabs(z.value) + std::fabs(x) + std::fabs(y) + std::fabs(d.slope_.x) * (grid.width() + 1) +
                 std::fabs(d.slope_.y) * (grid.height() + 1) + z.error;
  if (!(d.magnitude_ <= reach)) {
    d.slope_ = {0, 0};
    d.base_ = inf;
    return d;
  }
  if (z.slope == Point2d{0, 0}) {
    d.base_ = z.error == 0 ? z.value : std::nextafter(z.value + z.error, inf);
    return d;
  }
  // 32 u covers the roundings here and in operator(), 2^-149 underflow in float (and so in double).
  double const margin = 32 * u * d.magnitude_ + 0x1p-149;
  d.base_ = z.value + x + y + z.error + std::max(d.slope_.x, 0.0) + std::max(d.slope_.y, 0.0) + margin;
  return d;
}

PixelDepth PixelDepth::below(Grid const& grid, AffineDepth const& z)
{
  PixelDepth d = above(grid, {z.at, -z.value, {-z.slope.x, -z.slope.y}, z.error});
  d.base_ = -d.base_;
  d.slope_ = {-d.slope_.x, -d.slope_.y};
  return d;
}

double nearest(PixelDepth const& below, Spans const& spans)
{
  double least = inf;
  for (auto const& s : spans) least = std::min({least, below(s.begin, s.row), below(s.end - 1, s.row)});
  return least;
}

}  // namespace visibility
