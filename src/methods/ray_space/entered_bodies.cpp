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
  bodies_.push_back(
    {size(points_), size(points), size(chords_), size(body.edges), size(body.others), body.upright, beyond, box});
  for (std::size_t i = 0; i < points.size(); ++i) points_.push_back({points[i], margins[i], on_ground[i]});
  for (auto const* const chords : {&body.edges, &body.others})
    chords_.insert(chords_.end(), chords->begin(), chords->end());
  return size(bodies_) - 1;
}

bool EnteredBodies::is_touched(std::uint32_t body, Pixel const& pixel) const
{
  auto const& b = bodies_[body];
  bool some_below = false, some_above = false;
  for (std::uint32_t i = 0, n = b.upright ? b.points / 2 : b.points; i < n; ++i) {
    auto const& [p, margin, on_ground] = points_[b.first_point + i];
    double const x = pixel.t0 * p.u, y = pixel.t1 * p.u;
    some_below |= pixel.s0 <= p.v - std::min(x, y) + margin;
    some_above |= pixel.s1 >= p.v - std::max(x, y) - margin;
  }
  return some_below && some_above;
}

std::optional<Gate> EnteredBodies::gate(std::uint32_t body, Pixel const& pixel, CellSlice const& k)
{
  auto const& b = bodies_[body];
  std::size_t const n = b.upright ? b.points / 2 : b.points;
  below_.assign(n, false);
  above_.assign(n, false);
  bool any_below = false, any_above = false;
  for (std::size_t i = 0; i < n; ++i) {
    auto const& [p, margin, on_ground] = points_[b.first_point + i];
    double const x = pixel.t0 * p.u, y = pixel.t1 * p.u;
    any_below |= below_[i] = pixel.s1 <= p.v - std::max(x, y) - margin;
    any_above |= above_[i] = pixel.s0 >= p.v - std::min(x, y) + margin;
  }
  if (!any_below || !any_above) return std::nullopt;
  std::span<Chord const> const chords = std::span(chords_).subspan(b.first_chord, b.edges + b.others);
  GateEnds ends;
  add_chords(b, chords.first(b.edges), pixel, k, ends);
  if (ends.lacks_one()) add_chords(b, chords.subspan(b.edges), pixel, k, ends);
  if (ends.lacks_one()) return std::nullopt;
  double const back = frame_->half_length();
  return ends.gate(k, back, std::max(b.beyond, ends.distance(back)));
}

void EnteredBodies::add_chords(Body const& body, std::span<Chord const> chords, Pixel const& pixel, CellSlice const& k,
                               GateEnds& ends) const
{
  double const scale = frame_->half_length() + frame_->height();
  auto const* const points = &points_[body.first_point];
  for (auto const& chord : chords)
    for (auto const& [i, j] : {std::pair(chord.from, chord.to), std::pair(chord.to, chord.from)}) {
      if (!below_[i] || !above_[j]) continue;
      auto const &p = points[i], &q = points[j];
      double const margins = p.margin + q.margin;
      std::array<SlicePoint, 4> corner;
      if (options_.bounds == Bounds::exact) {
        Crossing const first(p.at, q.at, margins, scale, pixel.t0), second(p.at, q.at, margins, scale, pixel.t1);
        corner = {first(pixel.s0), first(pixel.s1), second(pixel.s0), second(pixel.s1)};
      } else {
        LinearCrossing const crossing(*frame_, p.at, q.at, margins);
        corner = {crossing(pixel.s0, pixel.t0), crossing(pixel.s1, pixel.t0), crossing(pixel.s0, pixel.t1),
                  crossing(pixel.s1, pixel.t1)};
      }
      SlicePoint all = corner[0];
      for (auto const& x : corner) {
        all.u_low = std::min(all.u_low, x.u_low), all.u_high = std::max(all.u_high, x.u_high);
        all.z_low = std::min(all.z_low, x.z_low), all.z_high = std::max(all.z_high, x.z_high);
      }
      if (!(all.u_low - k.u_out > 0x1p-30 * frame_->half_length())) continue;
      // At constant height the tangents are extreme where the distance is.
      std::span<SlicePoint const> lower(corner), upper(corner);
      SlicePoint above = all;
      if (p.at.z == q.at.z) lower = upper = std::span(&all, 1);
      if (body.upright) {
        double const z = points[body.points - 1].at.z, slack = 0x1p-47 * (std::fabs(z) + scale);
        above.z_low = z - slack, above.z_high = z + slack;
        upper = std::span(&above, 1);
      }
      if (chord.top) ends.take_top(k, upper, all.u_high);
      if (p.on_ground && q.on_ground)
        ends.take_ground(all.u_high);
      else if (chord.bottom && options_.umbra == Umbra::full)
        ends.take_bottom(k, lower, all.u_high);
    }
}

}  // namespace visibility::ray_space
