#include "visibility/raster/pixel_region.hpp"

#include "floor_division.hpp"

#include <algorithm>

namespace visibility {

namespace {

constexpr PixelRectangle no_pixel{0, 0, 0, 0};

struct Range {
  std::int64_t low, high;
};

/// The values of slope * t for t in [t0, t1).
Range range(std::int64_t slope, int t0, int t1)
{
  std::int64_t const first = slope * t0, last = slope * (t1 - 1);
  return {std::min(first, last), std::max(first, last)};
}

/// Shrinks [t0, t1) to the t with slope * t + constant >= 0. Requires: slope != 0.
void shrink(std::int64_t slope, std::int64_t constant, int& t0, int& t1)
{
  if (slope > 0)
    t0 = static_cast<int>(std::clamp<std::int64_t>(-detail::floor_division(constant, slope).quotient, t0, t1));
  else
    t1 = static_cast<int>(std::clamp<std::int64_t>(detail::floor_division(constant, -slope).quotient + 1, t0, t1));
}

/// Whether the closed interval of all points, enlarged, misses [low, high], for points of any size; NaN does not.
bool certainly_beside(std::span<Point2d const> points, double Point2d::*coordinate, double error, double low,
                      double high)
{
  bool below = !points.empty(), above = below;
  for (auto const& p : points) {
    below &= p.*coordinate < low && low - p.*coordinate > 2 * error;
    above &= p.*coordinate > high && p.*coordinate - high > 2 * error;
  }
  return below || above;
}

}  // namespace

void PixelRegion::reset()
{
  bounds_ = {0, 0, grid_.width(), grid_.height()};
  half_planes_.clear();
}

void PixelRegion::keep(PixelRectangle const& r) { bounds_ = common(bounds_, r); }

void PixelRegion::keep(HalfPlane const& h, Cover cover) { keep(pixels_of(grid_, h, cover)); }

void PixelRegion::keep(PixelHalfPlane const& h)
{
  if (bounds_.is_empty()) return;
  auto const x = range(h.a, bounds_.x0, bounds_.x1), y = range(h.b, bounds_.y0, bounds_.y1);
  if (x.low + y.low + h.c >= 0) return;
  if (x.high + y.high + h.c < 0) {
    bounds_ = no_pixel;
    return;
  }
  if (h.b != 0) shrink(h.b, x.high + h.c, bounds_.y0, bounds_.y1);
  if (h.a != 0) shrink(h.a, y.high + h.c, bounds_.x0, bounds_.x1);
  if (h.a != 0 && h.b != 0) half_planes_.push_back(h);
}

void PixelRegion::keep(Outline const& outline, Cover cover)
{
  if (bounds_.is_empty()) return;
  bool const inside = cover == Cover::inside;
  if (outline.points.empty()) {
    bounds_ = no_pixel;
    return;
  }
  if (!fixed_.assign(outline.points, grid_.origin(), grid_.step(), outline.error)) {
    if (inside ||
        certainly_beside(outline.points, &Point2d::x, outline.error.x, grid_.column_line(0),
                         grid_.column_line(grid_.width())) ||
        certainly_beside(outline.points, &Point2d::y, outline.error.y, grid_.row_line(0),
                         grid_.row_line(grid_.height())))
      bounds_ = no_pixel;
    return;
  }
  fixed_.reduce_to_hull();
  auto const& hull = fixed_.points;
  if (inside && hull.size() < 3) {
    bounds_ = no_pixel;
    return;
  }
  keep(pixel_bounds(cover));
  for (std::size_t i = 0, n = hull.size(); n > 1 && i < n && !bounds_.is_empty(); ++i) {
    auto const &p = hull[i], &q = hull[i + 1 == n ? 0 : i + 1];
    if (p.u == q.u || p.v == q.v) continue;  // decided by the bounds
    keep(detail::left_of(p, q, fixed_, inside ? detail::EdgeCover::inside : detail::EdgeCover::touching));
  }
}

PixelRectangle PixelRegion::pixel_bounds(Cover cover) const
{
  int const f = fixed_.fraction;
  auto const clip = [](std::int64_t t, int size) { return static_cast<int>(std::clamp<std::int64_t>(t, 0, size)); };
  if (cover == Cover::inside) {
    auto const box = fixed_.inner_bounds();
    return {clip(detail::ceil_units(box.u0, f), grid_.width()), clip(detail::ceil_units(box.v0, f), grid_.height()),
            clip(detail::floor_units(box.u1, f), grid_.width()), clip(detail::floor_units(box.v1, f), grid_.height())};
  }
  auto const box = fixed_.outer_bounds();
  return {
    clip(detail::ceil_units(box.u0, f) - 1, grid_.width()), clip(detail::ceil_units(box.v0, f) - 1, grid_.height()),
    clip(detail::floor_units(box.u1, f) + 1, grid_.width()), clip(detail::floor_units(box.v1, f) + 1, grid_.height())};
}

void PixelRegion::spans(Spans& spans)
{
  spans.clear();
  if (bounds_.is_empty()) return;
  auto const rows = static_cast<std::size_t>(bounds_.y1 - bounds_.y0);
  left_.assign(rows, bounds_.x0);
  right_.assign(rows, bounds_.x1);
  for (auto const& h : half_planes_) {
    // Bounds found later may have made it redundant.
    if (range(h.a, bounds_.x0, bounds_.x1).low + range(h.b, bounds_.y0, bounds_.y1).low + h.c >= 0) continue;
    detail::clip_rows(h, bounds_, left_.data(), right_.data());
  }
  spans.reserve(rows);
  for (std::size_t k = 0; k < rows; ++k)
    if (left_[k] < right_[k]) spans.push_back({bounds_.y0 + static_cast<int>(k), left_[k], right_[k]});
}

Spans inner(Grid const& grid, std::span<Outline const> outlines)
{
  PixelRegion region(grid);
  for (auto const& o : outlines) region.keep(o, Cover::inside);
  Spans spans;
  region.spans(spans);
  return spans;
}

Spans outer(Grid const& grid, Outline const& outline)
{
  PixelRegion region(grid);
  region.keep(outline, Cover::touching);
  Spans spans;
  region.spans(spans);
  return spans;
}

}  // namespace visibility
