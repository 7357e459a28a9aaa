#include "visibility/methods/ray_space/refined_map.hpp"

#include <algorithm>

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
  : frame_(&frame), map_(&map), options_(options), bodies_(frame, options)
{
  if (options.refinement > 0)
    roots_.resize(static_cast<std::size_t>(frame.rows()) * static_cast<std::size_t>(frame.columns()));
}

void RefinedMap::note(int row, int column, std::uint32_t body)
{
  auto& at = root(row, column);
  notes_.push_back({body, at.last_note});
  at.last_note = static_cast<std::int32_t>(notes_.size()) - 1;
}

std::uint32_t RefinedMap::part(int row, int column)
{
  auto& at = root(row, column);
  if (at.part < 0) {
    at.part = static_cast<std::int32_t>(parts_.size());
    parts_.emplace_back();
    parts_.back().pixel_ = frame_->pixel(row, column);
    parts_.back().slice_ = frame_->cell_slice(parts_.back().pixel_);
  }
  auto& part = parts_[static_cast<std::size_t>(at.part)];
  auto const before = static_cast<std::ptrdiff_t>(part.bodies_.size());
  for (; at.last_note >= 0; at.last_note = notes_[static_cast<std::size_t>(at.last_note)].before)
    part.bodies_.push_back(notes_[static_cast<std::size_t>(at.last_note)].body);
  std::reverse(part.bodies_.begin() + before, part.bodies_.end());
  part.gates_ = {};
  for (int k = 0; k < map_->components(); ++k) {
    Gate const g = map_->gate(row, column, k);
    if (g.beyond == std::numeric_limits<float>::infinity()) break;
    part.gates_.keep(g);
  }
  return static_cast<std::uint32_t>(at.part);
}

std::optional<std::uint32_t> RefinedMap::halves(std::uint32_t whole, double distance)
{
  if (parts_[whole].parts_ < 0) divide(whole, distance);
  auto const first = parts_[whole].parts_;
  if (first < 0) return std::nullopt;
  for (int i = 0; i < 2; ++i) update(parts_[static_cast<std::size_t>(first + i)], parts_[whole]);
  return static_cast<std::uint32_t>(first);
}

void RefinedMap::divide(std::uint32_t index, double distance)
{
  auto const [s0, s1, t0, t1] = parts_[index].pixel_;
  auto const s = parts_[index].halved_s_, t = parts_[index].halved_t_;
  bool const may_s = s < options_.refinement, may_t = t < options_.refinement;
  if (!may_s && !may_t) return;
  bool const in_t = may_t && (!may_s || (t1 - t0) * distance > s1 - s0);
  parts_[index].parts_ = static_cast<std::int32_t>(parts_.size());
  double const middle = in_t ? 0.5 * t0 + 0.5 * t1 : 0.5 * s0 + 0.5 * s1;
  for (int i = 0; i < 2; ++i) {
    auto& half = parts_.emplace_back();
    half.pixel_ = parts_[index].pixel_;
    (in_t ? i == 0 ? half.pixel_.t1 : half.pixel_.t0 : i == 0 ? half.pixel_.s1 : half.pixel_.s0) = middle;
    half.slice_ = frame_->cell_slice(half.pixel_);
    half.halved_s_ = static_cast<std::int8_t>(s + !in_t);
    half.halved_t_ = static_cast<std::int8_t>(t + in_t);
  }
}

void RefinedMap::update(Part& half, Part const& whole)
{
  if (half.is_empty()) return;
  for (auto const& g : whole.gates()) half.gates_.add(g, options_.components);
  for (; half.seen_ < whole.bodies_.size(); ++half.seen_) {
    auto const body = whole.bodies_[half.seen_];
    auto const passing = bodies_.passing(body, half.pixel_);
    if (!passing.some_meet) continue;
    auto const gates = half.gates();
    if (!gates.empty() && bodies_.adds_nothing(body, gates.front(), half.slice_)) continue;
    auto const gate = bodies_.gate(body, passing, half.pixel_, half.slice_);
    if (gate && !half.gates_.add(*gate, options_.components)) continue;
    half.bodies_.push_back(body);
  }
}

void RefinedMap::raise(std::uint32_t index)
{
  auto& whole = parts_[index];
  if (whole.parts_ < 0) return;
  auto const &a = parts_[static_cast<std::size_t>(whole.parts_)],
             &b = parts_[static_cast<std::size_t>(whole.parts_) + 1];
  if (a.is_empty() || b.is_empty()) {
    for (auto const& g : (a.is_empty() ? b : a).gates()) whole.gates_.add(g, options_.components);
    return;
  }
  for (auto const& g : a.gates())
    for (auto const& h : b.gates()) whole.gates_.add(common(g, h), options_.components);
}

void RefinedMap::raise(int row, int column)
{
  for (auto const& g : parts_[static_cast<std::size_t>(root(row, column).part)].gates())
    map_->insert(row, column, std::span(&g, 1));
}

}  // namespace visibility::ray_space
