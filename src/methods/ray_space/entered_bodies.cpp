#include "visibility/methods/ray_space/entered_bodies.hpp"

#include "visibility/methods/ray_space/crossing.hpp"

#include <algorithm>
#include <array>

namespace visibility::ray_space {

std::uint32_t EnteredBodies::add(Chords const& body, std::span<LocalPoint const> points,
                                 std::span<double const> margins, std::vector<bool> const& on_ground,
                                 LocalBox const& box, float beyond)
{
  auto const size = [](auto const& list) { return static_cast<std::uint32_t>(list.size()); };
  bodies_.push_back({size(points_), size(points), size(chords_), size(body.edges), size(body.others), body.upright,
                     std::ranges::find(on_ground, true) != on_ground.end(), beyond, box});
  for (std::size_t i = 0; i < points.size(); ++i) points_.push_back({points[i], margins[i], on_ground[i]});
  for (auto const* const chords : {&body.edges, &body.others})
    chords_.insert(chords_.end(), chords->begin(), chords->end());
  return size(bodies_) - 1;
}

EnteredBodies::Passing EnteredBodies::passing(std::uint32_t body, Pixel const& pixel) const
{
  auto const& b = bodies_[body];
  Passing out{0, 0, false};
  bool some_below = false, some_above = false;
  for (std::uint32_t i = 0, n = b.upright ? b.points / 2 : b.points; i < n; ++i) {
    auto const& [p, margin, on_ground] = points_[b.first_point + i];
    double const x = pixel.t0 * p.u, y = pixel.t1 * p.u, least = p.v - std::max(x, y) - margin,
                 most = p.v - std::min(x, y) + margin;
    some_below |= pixel.s0 <= most;
    some_above |= pixel.s1 >= least;
    out.below |= std::uint64_t{pixel.s1 <= least} << i;
    out.above |= std::uint64_t{pixel.s0 >= most} << i;
  }
  out.some_meet = some_below && some_above;
  return out;
}

Reach EnteredBodies::reach(std::uint32_t body, CellSlice const& k) const
{
  auto const& b = bodies_[body];
  Reach out = reach_of(b.box, b.on_ground, k);
  out.from = std::max(out.from, double(b.beyond));
  return out;
}

std::optional<Gate> EnteredBodies::gate(std::uint32_t body, Passing const& passing, Pixel const& pixel,
                                        CellSlice const& k) const
{
  if (!passing.all_meet()) return std::nullopt;
  auto const& b = bodies_[body];
  auto const best = b.upright ? upright_ends(b, passing, pixel, k) : ends(b, passing, pixel, k);
  if (best.lacks_one()) return std::nullopt;
  double const back = frame_->half_length();
  return best.gate(k, back, std::max(b.beyond, best.distance(back)));
}

/// Where the lines at the corners of the pixel cross the chord.
std::array<SlicePoint, 4> EnteredBodies::corners(BodyPoint const& p, BodyPoint const& q, Pixel const& pixel) const
{
  double const margins = p.margin + q.margin, scale = frame_->half_length() + frame_->height();
  if (options_.bounds == Bounds::exact) {
    Crossing const first(p.at, q.at, margins, scale, pixel.t0), second(p.at, q.at, margins, scale, pixel.t1);
    return {first(pixel.s0), first(pixel.s1), second(pixel.s0), second(pixel.s1)};
  }
  LinearCrossing const crossing(*frame_, p.at, q.at, margins);
  return {crossing(pixel.s0, pixel.t0), crossing(pixel.s1, pixel.t0), crossing(pixel.s0, pixel.t1),
          crossing(pixel.s1, pixel.t1)};
}

/// Calls take(chord, its points, corners, bounds of them) for chords that all lines of the pixel cross in front of the
/// cell.
template <class Take>
void EnteredBodies::each_chord(Body const& body, std::span<Chord const> chords, Passing const& passing,
                               Pixel const& pixel, CellSlice const& k, Take&& take) const
{
  auto const* const points = &points_[body.first_point];
  for (auto const& chord : chords) {
    bool const forward = (passing.below >> chord.from & passing.above >> chord.to & 1) != 0;
    if (!forward && (passing.above >> chord.from & passing.below >> chord.to & 1) == 0) continue;
    auto const &p = points[forward ? chord.from : chord.to], &q = points[forward ? chord.to : chord.from];
    auto const corner = corners(p, q, pixel);
    SlicePoint all = corner[0];
    for (auto const& x : corner) {
      all.u_low = std::min(all.u_low, x.u_low), all.u_high = std::max(all.u_high, x.u_high);
      all.z_low = std::min(all.z_low, x.z_low), all.z_high = std::max(all.z_high, x.z_high);
    }
    if (all.u_low - k.u_out > 0x1p-30 * frame_->half_length()) take(chord, p, q, corner, all);
  }
}

GateEnds EnteredBodies::ends(Body const& body, Passing const& passing, Pixel const& pixel, CellSlice const& k) const
{
  GateEnds out;
  auto const take = [&](Chord const& chord, BodyPoint const& p, BodyPoint const& q,
                        std::array<SlicePoint, 4> const& corner, SlicePoint const& all) {
    // At constant height the tangents are extreme where the distance is.
    auto const extremes = p.at.z == q.at.z ? std::span(&all, 1) : std::span<SlicePoint const>(corner);
    if (chord.top) out.take_top(k, extremes, all.u_high);
    if (p.on_ground && q.on_ground)
      out.take_ground(all.u_high);
    else if (chord.bottom && options_.umbra == Umbra::full)
      out.take_bottom(k, extremes, all.u_high);
  };
  auto const chords = std::span(chords_).subspan(body.first_chord, body.edges + body.others);
  each_chord(body, chords.first(body.edges), passing, pixel, k, take);
  if (out.lacks_one()) each_chord(body, chords.subspan(body.edges), passing, pixel, k, take);
  return out;
}

/// At a constant height every tangent is monotone in the distance: the nearest or the farthest chord is best.
GateEnds EnteredBodies::upright_ends(Body const& body, Passing const& passing, Pixel const& pixel,
                                     CellSlice const& k) const
{
  SlicePoint near{0, HUGE_VAL, 0, 0}, far{-HUGE_VAL, 0, 0, 0};
  auto const take = [&](Chord const&, BodyPoint const&, BodyPoint const&, std::array<SlicePoint, 4> const&,
                        SlicePoint const& all) {
    if (all.u_high < near.u_high) near = all;
    if (all.u_low > far.u_low) far = all;
  };
  auto const chords = std::span(chords_).subspan(body.first_chord, body.edges + body.others);
  each_chord(body, chords.first(body.edges), passing, pixel, k, take);
  if (near.u_high == HUGE_VAL) each_chord(body, chords.subspan(body.edges), passing, pixel, k, take);
  bool const open_below = points_[body.first_point].on_ground;
  if (near.u_high == HUGE_VAL || (!open_below && options_.umbra == Umbra::half)) return {};
  double const bottom = points_[body.first_point].at.z, top = points_[body.first_point + body.points - 1].at.z;
  return GateEnds::of_upright(k, near, far, bottom, top, open_below, frame_->half_length() + frame_->height());
}

}  // namespace visibility::ray_space
