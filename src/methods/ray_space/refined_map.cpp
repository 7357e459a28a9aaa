#include "visibility/methods/ray_space/refined_map.hpp"

#include <algorithm>
#include <limits>

namespace visibility::ray_space {

namespace {

/// What two gates hide both, as one gate. Each end is the worse one, its line no better than either.
Gate common(Gate const& a, Gate const& b)
{
  auto const worst = [](GateEnd const& x, GateEnd const& y, auto&& of) {
    return GateEnd{of(x.slope, y.slope), of(x.base, y.base), of(x.separating, y.separating)};
  };
  auto const lower = [](float x, float y) { return std::min(x, y); };
  auto const upper = [](float x, float y) { return std::max(x, y); };
  return {worst(a.top, b.top, lower), worst(a.bottom, b.bottom, upper), upper(a.beyond, b.beyond)};
}

}  // namespace

RefinedMap::RefinedMap(Frame const& frame, OcclusionMap& map, Options const& options)
  : frame_(&frame), map_(&map), options_(options), halvings_(options.halvings()), bodies_(frame, options)
{
  if (halvings_ > 0) roots_.resize(static_cast<std::size_t>(frame.rows()) * static_cast<std::size_t>(frame.columns()));
}

void RefinedMap::note(int row, int column, std::uint32_t body)
{
  auto& at = root(row, column);
  notes_.push_back({body, at.last_note});
  at.last_note = static_cast<std::int32_t>(notes_.size()) - 1;
}

std::uint32_t RefinedMap::make_part(Pixel const& pixel, CellSlice const& slice, int halved_s, int halved_t)
{
  auto& part = parts_.emplace_back();
  part.pixel_ = pixel;
  part.slice_ = slice;
  CellSlice const own = frame_->cell_slice(pixel);
  part.is_empty_ = own.u_in > own.u_out;
  part.halved_s_ = static_cast<std::int8_t>(halved_s);
  part.halved_t_ = static_cast<std::int8_t>(halved_t);
  gates_.resize(first_gate(static_cast<std::uint32_t>(parts_.size())));
  return static_cast<std::uint32_t>(parts_.size()) - 1;
}

std::uint32_t RefinedMap::part(int row, int column)
{
  auto& at = root(row, column);
  if (at.part < 0)
    at.part = static_cast<std::int32_t>(make_part(frame_->pixel(row, column), *frame_->cell_slice(row, column), 0, 0));
  auto const index = static_cast<std::uint32_t>(at.part);
  auto& part = parts_[index];
  auto const before = static_cast<std::ptrdiff_t>(part.bodies_.size());
  for (; at.last_note >= 0; at.last_note = notes_[static_cast<std::size_t>(at.last_note)].before) {
    part.bodies_.push_back(notes_[static_cast<std::size_t>(at.last_note)].body);
    part.reach_.extend(bodies_.reach(part.bodies_.back(), part.slice_));
  }
  std::reverse(part.bodies_.begin() + before, part.bodies_.end());
  part.gates_ = 0;
  auto gates = list(index);
  for (int k = 0; k < map_->components(); ++k) {
    Gate const g = map_->gate(row, column, k);
    if (g.beyond == std::numeric_limits<float>::infinity()) break;
    gates.keep(g);
  }
  part.gates_ = static_cast<std::int8_t>(gates.size());
  return index;
}

bool RefinedMap::is_surely_visible(std::uint32_t index, Extent const& e) const
{
  auto const& part = parts_[index];
  if (part.bodies_.empty()) return part.gates_ < 2;
  auto const& [u_in, u_out, height] = part.slice_;
  auto r = part.reach_;
  for (auto const& g : gates(index)) r.extend({g.top.slope, g.bottom.slope, g.beyond});
  double const back = frame_->half_length(), near = e.near - back, far = e.far - back;
  if (r.from >= e.near) return true;
  if (!(near > u_out)) return false;
  auto const top = [&](double u) { return height + r.top * (u - (r.top >= 0 ? u_in : u_out)); };
  auto const bottom = [&](double u) { return r.bottom * (u - (r.bottom >= 0 ? u_out : u_in)); };
  return e.high >= std::min(top(near), top(far)) || e.low <= std::max(bottom(near), bottom(far));
}

std::optional<std::uint32_t> RefinedMap::halves(std::uint32_t whole, double distance)
{
  if (parts_[whole].parts_ < 0) divide(whole, distance);
  if (parts_[whole].parts_ < 0) return std::nullopt;
  return static_cast<std::uint32_t>(parts_[whole].parts_);
}

void RefinedMap::divide(std::uint32_t index, double distance)
{
  Pixel const whole = parts_[index].pixel_;
  CellSlice const slice = parts_[index].slice_;
  int const s = parts_[index].halved_s_, t = parts_[index].halved_t_;
  bool const may_s = s < halvings_, may_t = t < halvings_;
  if (!may_s && !may_t) return;
  bool const in_t = may_t && (!may_s || (whole.t1 - whole.t0) * distance > whole.s1 - whole.s0);
  Pixel a = whole, b = whole;
  if (in_t)
    a.t1 = b.t0 = 0.5 * whole.t0 + 0.5 * whole.t1;
  else
    a.s1 = b.s0 = 0.5 * whole.s0 + 0.5 * whole.s1;
  auto const first = make_part(a, slice, s + !in_t, t + in_t);
  make_part(b, slice, s + !in_t, t + in_t);
  parts_[index].parts_ = static_cast<std::int32_t>(first);
}

void RefinedMap::update(std::uint32_t index, std::uint32_t whole)
{
  auto& half = parts_[index];
  if (half.is_empty()) return;
  auto gates = list(index);
  for (auto const& g : this->gates(whole)) gates.add(g);
  auto const& bodies = parts_[whole].bodies_;
  if (half.bodies_.empty()) half.bodies_.reserve(bodies.size() - half.seen_);
  for (; half.seen_ < bodies.size(); ++half.seen_) {
    auto const body = bodies[half.seen_];
    auto const passing = bodies_.passing(body, half.pixel_);
    if (!passing.some_meet) continue;
    auto const reach = bodies_.reach(body, half.slice_);
    if (gates.size() > 0 && reaches(gates.gates().front(), reach)) continue;
    auto const gate = bodies_.gate(body, passing, half.pixel_, half.slice_);
    if (gate && !gates.add(*gate)) continue;
    half.bodies_.push_back(body);
    half.reach_.extend(reach);
  }
  half.gates_ = static_cast<std::int8_t>(gates.size());
}

void RefinedMap::raise(std::uint32_t index)
{
  auto& whole = parts_[index];
  if (whole.parts_ < 0) return;
  auto const first = static_cast<std::uint32_t>(whole.parts_), second = first + 1;
  auto gates = list(index);
  if (parts_[first].is_empty() || parts_[second].is_empty()) {
    for (auto const& g : this->gates(parts_[first].is_empty() ? second : first)) gates.add(g);
  } else {
    for (auto const& g : this->gates(first))
      for (auto const& h : this->gates(second)) gates.add(common(g, h));
  }
  whole.gates_ = static_cast<std::int8_t>(gates.size());
}

void RefinedMap::raise(int row, int column)
{
  for (auto const& g : gates(static_cast<std::uint32_t>(root(row, column).part)))
    map_->insert(row, column, std::span(&g, 1));
}

}  // namespace visibility::ray_space
