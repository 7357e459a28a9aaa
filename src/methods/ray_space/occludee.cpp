#include "visibility/methods/ray_space/occludee.hpp"

#include "visibility/methods/ray_space/footprint.hpp"

#include <algorithm>
#include <array>

namespace visibility::ray_space {

template <class AllHidden>
bool OccludeeTest::in_every_family(AllHidden&& all_hidden)
{
  std::size_t const n = families_.size();
  for (std::size_t k = 0, first = last_family_; k < n; ++k) {
    std::size_t const f = (first + k) % n;
    int shown = 0;
    if (all_hidden(families_[f], k == 0 ? last_row_ : 0, shown)) continue;
    last_family_ = f;
    last_row_ = shown;
    return false;
  }
  return true;
}

namespace {

/// Whether of the pixels [from, to) of the row each hides the extent, or else is_hidden(column).
template <class IsHidden>
bool each_hides(OcclusionMap const& map, int row, int from, int to, Extent const& extent, IsHidden&& is_hidden)
{
  for (int c = map.first_visible(row, from, to, extent); c < to; c = map.first_visible(row, c + 1, to, extent))
    if (!is_hidden(c)) return false;
  return true;
}

}  // namespace

bool OccludeeTest::hidden(Box const& box, Pixels pixels)
{
  return in_every_family([&](Family const& f, int start, int& shown) {
    if (!in_reach(*f.frame, box)) return false;
    auto const local = local_box(*f.frame, box);
    bool const asks_parts = f.refined != nullptr && pixels == Pixels::refined;
    bool has_points = false;
    if (local && asks_parts && is_last_shown(f)) {
      localize(*f.frame, box.corners()), has_points = true;
      if (shows_where_the_last_did(f)) return false;
    }
    auto const is_hidden = [&](int row, int from, int to) {
      shown = row;
      return each_hides(*f.map, row, from, to, local->extent, [&](int column) {
        if (!asks_parts) return false;
        if (!has_points) localize(*f.frame, box.corners()), has_points = true;
        return hidden_in_pixel(f, row, column);
      });
    };
    return !local || every_row(*f.frame, *local, is_hidden, start);
  });
}

bool OccludeeTest::hidden(Box const& bounds, std::span<Point3d const> points)
{
  return in_every_family([&](Family const& f, int start, int& shown) {
    if (!in_reach(*f.frame, bounds)) return false;
    auto const local = local_box(*f.frame, bounds);
    if (!local) return true;
    localize(*f.frame, points);
    if (is_last_shown(f) && shows_where_the_last_did(f)) return false;
    auto const is_hidden = [&](int row, int from, int to) {
      shown = row;
      double const t0 = f.frame->t(row), t1 = f.frame->t(row + 1);
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (std::size_t i = 0; i < points_.size(); ++i) {
        auto const& p = points_[i];
        low = std::min(low, p.v - std::max(t0 * p.u, t1 * p.u) - margin_[i]);
        high = std::max(high, p.v - std::min(t0 * p.u, t1 * p.u) + margin_[i]);
      }
      from = std::max(from, f.frame->columns_below(low));
      to = std::min(to, f.frame->columns_from(high));
      return each_hides(*f.map, row, from, to, local->extent,
                        [&](int column) { return hidden_in_pixel(f, row, column); });
    };
    return every_row(*f.frame, *local, is_hidden, start);
  });
}

void OccludeeTest::localize(Frame const& frame, std::span<Point3d const> points)
{
  frame_ = &frame;
  points_.clear();
  margin_.clear();
  nearest_ = HUGE_VAL, farthest_ = -HUGE_VAL;
  for (auto const& p : points) {
    points_.push_back(frame.local(p));
    nearest_ = std::min(nearest_, points_.back().u);
    farthest_ = std::max(farthest_, points_.back().u);
  }
  // What is behind the cell is not looked at.
  nearest_ = std::max(nearest_, -frame.half_length());
  keep_plan_of_upright();
  for (auto const& p : points_)
    margin_.push_back(frame.margin({std::max(std::fabs(p.u), std::fabs(farthest_)), p.v, 0}));
  low_side_.resize(points_.size());
  high_side_.resize(points_.size());
}

/// Of points that are one polygon in plan at its lowest and at its highest height, one of each two is enough.
void OccludeeTest::keep_plan_of_upright()
{
  auto const [lowest, highest] = std::ranges::minmax(points_, {}, &LocalPoint::z);
  lowest_ = lowest.z, highest_ = highest.z;
  is_upright_ = std::ranges::all_of(points_, [&](LocalPoint const& p) { return p.z == lowest_ || p.z == highest_; });
  if (!is_upright_ || lowest_ == highest_) return;
  auto const has = [&](double u, double v, double z) {
    return std::ranges::any_of(points_, [&](LocalPoint const& p) { return p.u == u && p.v == v && p.z == z; });
  };
  is_upright_ = std::ranges::all_of(
    points_, [&](LocalPoint const& p) { return has(p.u, p.v, p.z == lowest_ ? highest_ : lowest_); });
  if (is_upright_) std::erase_if(points_, [&](LocalPoint const& p) { return p.z == highest_; });
}

/// A point of the hull within du and dz of (u, z).
void OccludeeTest::add(double u, double z, double du, double dz)
{
  if (is_upright_) {
    clipped_near_ = std::min(clipped_near_, u - du);
    clipped_far_ = std::max(clipped_far_, u + du);
    return;
  }
  add_extent(u - du, u + du, z - dz, z + dz);
}

void OccludeeTest::add_extent(double near, double far, double low, double high)
{
  double const back = frame_->half_length();
  extents_.push_back(
    {near_of(near, back), far_of(far, back), float_below(safely_below(low)), float_above(safely_above(high))});
}

/// Fills extents_ with points whose hull contains what of the hull of points_ the lines of the pixel meet.
void OccludeeTest::clip(Pixel const& pixel)
{
  extents_.clear();
  clipped_near_ = HUGE_VAL, clipped_far_ = -HUGE_VAL;
  std::size_t const n = points_.size();
  auto const [s0, s1, t0, t1] = pixel;
  // The lines of a pixel lie between min(s0 + t0 u, s0 + t1 u) and max(s1 + t0 u, s1 + t1 u). Between the ends of the
  // hull the chord of the one is below it (concave), and that of the other above.
  double const low_a = std::min(t0 * nearest_, t1 * nearest_), low_b = std::min(t0 * farthest_, t1 * farthest_);
  double const high_a = std::max(t0 * nearest_, t1 * nearest_), high_b = std::max(t0 * farthest_, t1 * farthest_);
  double const length = farthest_ - nearest_;
  double const low_t = length > 0 ? (low_b - low_a) / length : 0, high_t = length > 0 ? (high_b - high_a) / length : 0;
  for (std::size_t i = 0; i < n; ++i) {
    auto const& p = points_[i];
    double const along = p.u - nearest_;
    low_side_[i] = p.v - (s0 + low_a + low_t * along);  // >= 0 inside
    high_side_[i] = (s1 + high_a + high_t * along) - p.v;
    if (low_side_[i] >= -margin_[i] && high_side_[i] >= -margin_[i]) add(p.u, p.z, 0, 0);
  }
  for (auto const* const side : {&low_side_, &high_side_})
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        double const a = (*side)[i], b = (*side)[j];
        if (!(a < 0 && b > 0)) continue;
        auto const &p = points_[i], &q = points_[j];
        double const width = b - a, off = (margin_[i] + margin_[j]) / (4 * width) + 0x1p-50;
        for (double const part : {std::max(0.0, -a / width - off), std::min(1.0, -a / width + off)})
          add(p.u + part * (q.u - p.u), p.z + part * (q.z - p.z), 0x1p-48 * (std::fabs(p.u) + std::fabs(q.u)),
              0x1p-48 * (std::fabs(p.z) + std::fabs(q.z)));
      }
  if (is_upright_ && clipped_near_ <= clipped_far_) add_extent(clipped_near_, clipped_far_, lowest_, highest_);
}

/// A gate hides a convex set iff it hides its extreme points.
bool OccludeeTest::hidden_by_one_of(std::span<Gate const> gates) const
{
  auto const line = [](GateEnd const& end, double u) { return double(end.base) + double(end.slope) * u; };
  return std::ranges::any_of(gates, [&](Gate const& g) {
    return std::ranges::all_of(extents_, [&](Extent const& e) {
      double const near = e.near, far = e.far;
      return e.near > g.beyond && line(g.top, near) > e.high && line(g.top, far) > e.high &&
             (reaches_ground(g) || (line(g.bottom, near) < e.low && line(g.bottom, far) < e.low));
    });
  });
}

bool OccludeeTest::hidden_in_pixel(Family const& f, int row, int column)
{
  if (f.frame->cell_slice(row, column) == nullptr) return true;
  if (f.refined != nullptr) {
    bool const all = hidden_in_part(*f.refined, f.refined->part(row, column));
    if (all) f.refined->raise(row, column);
    return all;
  }
  clip(f.frame->pixel(row, column));
  std::array<Gate, Options::max_components> room;
  GateList list(room.data(), 0, f.map->components());
  for (int k = 0; k < f.map->components(); ++k) list.keep(f.map->gate(row, column, k));
  return hidden_by_one_of(list.gates());
}

/// Whether what was not hidden last was so in a part of this map, and no body was entered since.
bool OccludeeTest::is_last_shown(Family const& f) const
{
  return f.refined != nullptr && last_map_ == f.refined && last_notes_ == f.refined->notes();
}

bool OccludeeTest::shows_where_the_last_did(Family const& f)
{
  clip((*f.refined)[last_part_].pixel());
  return !extents_.empty() && !hidden_by_one_of(f.refined->gates(last_part_));
}

/// `whole`: what the part is a half of.
bool OccludeeTest::hidden_in_part(RefinedMap& map, std::uint32_t part, std::optional<std::uint32_t> whole)
{
  if (map[part].is_empty()) return true;
  clip(map[part].pixel());
  if (extents_.empty()) return true;
  if (whole) map.update(part, *whole);
  if (hidden_by_one_of(map.gates(part))) return true;
  auto const is_visible = [&](Extent const& e) { return map.is_surely_visible(part, e); };
  if (std::ranges::any_of(extents_, is_visible)) return false;
  auto const first = map.halves(part, std::max(0.0, nearest_));
  if (!first) {
    last_map_ = &map;
    last_part_ = part;
    last_notes_ = map.notes();
    return false;
  }
  if (!hidden_in_part(map, *first, part) || !hidden_in_part(map, *first + 1, part)) return false;
  map.raise(part);
  return true;
}

}  // namespace visibility::ray_space
