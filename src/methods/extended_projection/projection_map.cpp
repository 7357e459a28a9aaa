#include "visibility/methods/extended_projection/projection_map.hpp"

#include "reprojection.hpp"
#include "view_range.hpp"

#include "visibility/methods/extended_projection/plane_choice.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace visibility::extended_projection {

namespace {

/// Parts that are less deep than this share of their distance have one depth.
constexpr double least_slant = 1.0 / 64;

constexpr double inf = std::numeric_limits<double>::infinity();

}  // namespace

ProjectionMap::ProjectionMap(CellViews const& cell, double plane, Grid const& grid)
  : ProjectionMap(cell, plane, cell.near, grid, DepthMap<float>(grid.width(), grid.height()))
{
}

ProjectionMap::ProjectionMap(ProjectionMap const& from, double plane, Grid const& grid, Reprojection how)
  : ProjectionMap(from.cell(), plane, from.plane(), grid,
                  how == Reprojection::windows ? reproject_by_windows(from, plane, grid)
                                               : reproject_by_convolution(from, plane, grid))
{
}

ProjectionMap::ProjectionMap(CellViews const& cell, double plane, double improved_from, Grid const& grid,
                             DepthMap<float> depths)
  : cell_(&cell), plane_(plane), improved_from_(improved_from), map_(std::move(depths)), region_(grid)
{
}

bool ProjectionMap::seems_useful(Box const& box) const
{
  // Neither far behind the plane nor so far before it that little is left of it there.
  double const d = plane_ - cell_->near;
  if (box.max.z - cell_->near < 0.3 * d || box.min.z - cell_->near > 2 * d) return false;
  Grid const& g = grid();
  Rectangle const all{g.origin(), {g.column_line(g.width()), g.row_line(g.height())}};
  Rectangle const r = common(common_view(*cell_, box, plane_), all);
  double const x0 = std::ceil((r.low.x - g.origin().x) / g.step().x),
               y0 = std::ceil((r.low.y - g.origin().y) / g.step().y),
               x1 = std::floor((r.high.x - g.origin().x) / g.step().x),
               y1 = std::floor((r.high.y - g.origin().y) / g.step().y);
  if (!(x0 < x1 && y0 < y1)) return false;
  PixelRectangle const pixels{static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1), static_cast<int>(y1)};
  return !map_.hidden(pixels, static_cast<float>(box.min.z - cell_->near));
}

std::int64_t ProjectionMap::add(std::span<PartPoint const> part, PartDepth depth)
{
  if (part.size() < 3) return 0;
  // Look at it from each vertex, and see whether all views can have a pixel in common: a choice.
  std::size_t const n = part.size();
  views_.clear();
  errors_.clear();
  Range common_u{-inf, inf}, common_v{-inf, inf};
  for (auto const& c : cell_->vertices) {
    Range range_u, range_v;
    Point2d error{0, 0};
    for (auto const& p : part) {
      double const ratio = (plane_ - c.z) / (p.at.z - c.z);
      double const slack = ratio_slack(p, c.z);
      if (!in_domain(ratio) || !(slack < 1)) return 0;
      auto const u = view(c.x, p.at.x, p.error, ratio, slack), v = view(c.y, p.at.y, p.error, ratio, slack);
      views_.push_back({u.value, v.value});
      error = {std::max(error.x, u.error), std::max(error.y, v.error)};
      range_u.add(u.value);
      range_v.add(v.value);
    }
    errors_.push_back(error);
    common_u = {std::max(common_u.low, range_u.low), std::min(common_u.high, range_u.high)};
    common_v = {std::max(common_v.low, range_v.low), std::min(common_v.high, range_v.high)};
  }
  Grid const& g = grid();
  if (!(std::min(common_u.high, g.column_line(g.width())) - std::max(common_u.low, g.origin().x) >= g.step().x &&
        std::min(common_v.high, g.row_line(g.height())) - std::max(common_v.low, g.origin().y) >= g.step().y))
    return 0;

  region_.reset();
  for (std::size_t i = 0; i < errors_.size() && !region_.bounds().is_empty(); ++i)
    region_.keep(Outline{std::span(views_).subspan(i * n, n), errors_[i]}, Cover::inside);
  region_.spans(spans_);
  // The difference is rounded, which keeps the order of depths; equal ones may become of different ones, which is safe.
  double const farthest = deepest(part) - cell_->near;
  map_.write(spans_, PixelDepth::above(g, {.value = farthest}));
  if (depth == PartDepth::pixel && !spans_.empty() &&
      (farthest - (nearest(part) - cell_->near)) > least_slant * farthest)
    write_affine_depth(part, farthest);
  return pixel_count(spans_);
}

/// Writes a depth that is affine over the plane and, at the views of all points of the part from all vertices of the
/// cell, at least theirs: that suffices (proofs/extended_projection.md, "Depth for each pixel"). `spans_`, `views_` and
/// `errors_` are those of the part. The slope is a choice: least squares.
void ProjectionMap::write_affine_depth(std::span<PartPoint const> part, double farthest)
{
  std::size_t const n = part.size();
  double const count = static_cast<double>(views_.size());
  Point2d mean{0, 0};
  double mean_z = 0;
  for (auto const& x : views_) mean = {mean.x + x.x / count, mean.y + x.y / count};
  for (auto const& p : part) mean_z += (p.at.z - cell_->near) / static_cast<double>(n);
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    double const x = views_[i].x - mean.x, y = views_[i].y - mean.y, z = part[i % n].at.z - cell_->near - mean_z;
    xx += x * x, xy += x * y, yy += y * y, xz += x * z, yz += y * z;
  }
  double const determinant = xx * yy - xy * xy;
  Point2d const slope{(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant};
  double value = -inf, size = 0;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    auto const& p = part[i % n];
    double const z = p.at.z + p.depth_error - cell_->near, x = slope.x * (views_[i].x - mean.x),
                 y = slope.y * (views_[i].y - mean.y);
    value = std::max(value, z - x - y);
    size = std::max({size, std::fabs(p.at.z) + p.depth_error, std::fabs(z) + std::fabs(x) + std::fabs(y)});
  }
  double error = 16 * 0x1p-53 * size;
  for (auto const& e : errors_)
    error = std::max(error, 16 * 0x1p-53 * size + std::fabs(slope.x) * e.x + std::fabs(slope.y) * e.y);
  if (!std::isfinite(value) || !std::isfinite(error)) return;
  auto const depth =
    PixelDepth::above(grid(), {.at = mean, .value = value, .slope = slope, .error = error * (1 + 0x1p-40)});
  auto const& b = region_.bounds();
  double const least =
    std::min({depth(b.x0, b.y0), depth(b.x1 - 1, b.y0), depth(b.x0, b.y1 - 1), depth(b.x1 - 1, b.y1 - 1)});
  if (least < farthest) map_.write(spans_, depth);
}

bool ProjectionMap::slice_seems_useful(Box const& box) const
{
  Grid const& g = grid();
  auto const line = [](double x, double origin, double step, int count) {
    return std::clamp((x - origin) / step, 0.0, double(count));
  };
  PixelRectangle const pixels{static_cast<int>(std::ceil(line(box.min.x, g.origin().x, g.step().x, g.width()))),
                              static_cast<int>(std::ceil(line(box.min.y, g.origin().y, g.step().y, g.height()))),
                              static_cast<int>(line(box.max.x, g.origin().x, g.step().x, g.width())),
                              static_cast<int>(line(box.max.y, g.origin().y, g.step().y, g.height()))};
  return !map_.hidden(pixels, static_cast<float>(plane_ - cell_->near));
}

std::int64_t ProjectionMap::add_slice(std::span<ContourEdge const> contours, double error, double at, double low)
{
  if (!(at > cell_->near)) return 0;
  Grid const& g = grid();
  // Lines to a point of the map's plane pass the slice's this share of their way from the cell earlier.
  double const share = at < plane_ ? (plane_ - at) / (plane_ - cell_->near) * (1 + 0x1p-40) : 0;
  auto const reach = [](double low0, double high0, double low1, double high1) {
    return std::max(std::fabs(high0 - low1), std::fabs(high1 - low0)) * (1 + 0x1p-40);
  };
  Box const& c = cell_->bounds;
  Point2d const off{error + share * reach(c.min.x, c.max.x, g.origin().x, g.column_line(g.width())),
                    error + share * reach(c.min.y, c.max.y, g.origin().y, g.row_line(g.height()))};
  if (!(std::isfinite(off.x) && std::isfinite(off.y))) return 0;
  double const least = off.y > 0 ? std::nextafter(low + 2 * off.y, inf) : low;
  auto const spans = inner_even_odd(g, contours, {off.x * (1 + 0x1p-40), off.y * (1 + 0x1p-40)}, least);
  map_.write(spans, PixelDepth::above(g, {.value = plane_ - cell_->near}));
  return pixel_count(spans);
}

bool ProjectionMap::hides(Box const& b) const
{
  if (!(b.min.z > cell_->near)) return false;
  auto const [u, v] = cell_->is_box
                        ? box_view_range(cell_->bounds, b, plane_)
                        : BoxViewRange{view_range(cell_->profile_u, b.min.x, b.max.x, b.min.z, b.max.z, plane_),
                                       view_range(cell_->profile_v, b.min.y, b.max.y, b.min.z, b.max.z, plane_)};
  return hides({u.low, u.error}, {u.high, u.error}, {v.low, v.error}, {v.high, v.error}, b.min.z);
}

bool ProjectionMap::hides_improved(Box const& b) const
{
  if (!(b.min.z > cell_->near && b.min.z >= improved_from_) || b.max.z > plane_) return false;
  double const far_ratio = (plane_ - cell_->near) / (b.max.z - cell_->near),
               near_ratio = (plane_ - cell_->near) / (b.min.z - cell_->near);
  if (!in_domain(far_ratio) || !in_domain(near_ratio)) return false;
  // Supporting lines of the cell's side and the box: from low end to low end, from high end to high end.
  auto const segment = [&](double cell_low, double cell_high, double low, double high) {
    auto const a = view(cell_low, low, 0, near_ratio), b2 = view(cell_low, low, 0, far_ratio);
    auto const c = view(cell_high, high, 0, near_ratio), d = view(cell_high, high, 0, far_ratio);
    double const error = std::max({a.error, b2.error, c.error, d.error});
    std::pair<Bounded, Bounded> ends{{std::min(a.value, b2.value), error}, {std::max(c.value, d.value), error}};
    if (ends.first.value > ends.second.value) {  // beyond the vanishing point: any point between them
      double const middle = ends.second.value + (ends.first.value - ends.second.value) / 2;
      ends = {{middle, error}, {middle, error}};
    }
    return ends;
  };
  auto const [u0, u1] = segment(cell_->bounds.min.x, cell_->bounds.max.x, b.min.x, b.max.x);
  auto const [v0, v1] = segment(cell_->bounds.min.y, cell_->bounds.max.y, b.min.y, b.max.y);
  return hides(u0, u1, v0, v1, b.min.z);
}

bool ProjectionMap::hides(Bounded const& u0, Bounded const& u1, Bounded const& v0, Bounded const& v1, double w) const
{
  Grid const& g = grid();
  double const low_u = in_pixels(u0, -1, g.origin().x, g.step().x), high_u = in_pixels(u1, 1, g.origin().x, g.step().x),
               low_v = in_pixels(v0, -1, g.origin().y, g.step().y), high_v = in_pixels(v1, 1, g.origin().y, g.step().y);
  constexpr double margin = pixel_margin;
  if (!(low_u >= margin && low_v >= margin && high_u <= g.width() - margin && high_v <= g.height() - margin))
    return false;
  PixelRectangle const pixels{static_cast<int>(low_u - margin), static_cast<int>(low_v - margin),
                              static_cast<int>(high_u + margin) + 1, static_cast<int>(high_v + margin) + 1};
  return map_.hidden(pixels, -round_up<float>(-(w - cell_->near)));
}

}  // namespace visibility::extended_projection
