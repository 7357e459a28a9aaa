#include "visibility/methods/ray_space/occlusion_map.hpp"

#include "visibility/methods/ray_space/gate_list.hpp"
#include "visibility/methods/ray_space/options.hpp"

#include <array>

namespace visibility::ray_space {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Where no line of a pixel meets the cell, everything is hidden.
constexpr Gate closed{{0, infinity, infinity}, open_bottom, -infinity};
constexpr Gate empty{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}, infinity};

}  // namespace

OcclusionMap::OcclusionMap(Frame const& frame, int components)
  : columns_(frame.columns()), components_(components),
    data_(static_cast<std::size_t>(frame.rows()) * static_cast<std::size_t>(components) * fields *
          static_cast<std::size_t>(columns_))
{
  for (int row = 0; row < frame.rows(); ++row)
    for (int k = 0; k < components_; ++k)
      for (int c = 0; c < columns_; ++c) set(row, c, k, frame.cell_slice(row, c) ? empty : closed);
  constexpr Block nothing{infinity, -infinity, -infinity, infinity, infinity};
  std::size_t const blocks = frame.rows() > 0 ? block(frame.rows() - 1, columns_ - 1) + 1 : 0;
  least_.assign(blocks, nothing);
  most_.assign(blocks, nothing);
  for (int row = 0; row < frame.rows(); ++row) update_blocks(row, 0, columns_);
}

void OcclusionMap::insert(int row, int from, std::span<Gate const> gates)
{
  bool changed = false;
  for (std::size_t i = 0; i < gates.size(); ++i)
    if (gates[i].beyond != infinity) changed |= insert(row, from + static_cast<int>(i), gates[i]);
  if (changed) update_blocks(row, from, from + static_cast<int>(gates.size()));
}

/// Of blocks that hold pixels [from, to). Where no line meets the cell the bounds of the least are those of the others.
void OcclusionMap::update_blocks(int row, int from, int to)
{
  for (int start = from / block_size * block_size; start < to; start += block_size) {
    Block least{-infinity, infinity, infinity, -infinity, -infinity}, most = most_[block(row, start)];
    int const end = std::min(start + block_size, columns_);
    for (int c = start; c < end; ++c) {
      auto const at = [&](Field f) { return column(row, 0, f)[c]; };
      least.beyond = std::max(least.beyond, at(beyond));
      least.top_base = std::min(least.top_base, at(top_base));
      least.bottom_base = std::max(least.bottom_base, at(bottom_base));
      if (at(top_base) != infinity) least.top_slope = std::min(least.top_slope, at(top_slope));
      if (at(bottom_base) != -infinity) least.bottom_slope = std::max(least.bottom_slope, at(bottom_slope));
    }
    if (least.top_base == infinity) least.top_slope = 0;  // no infinity times zero
    if (least.bottom_base == -infinity) least.bottom_slope = 0;
    least_[block(row, start)] = least;
    for (int c = std::max(start, from); c < std::min(end, to); ++c)
      for (int k = 0; k < components_; ++k) {
        auto const at = [&](Field f) { return column(row, k, f)[c]; };
        if (at(beyond) == infinity) break;
        most.beyond = std::min(most.beyond, at(beyond));
        most.top_slope = std::max(most.top_slope, at(top_slope));
        most.top_base = std::max(most.top_base, at(top_base));
        most.bottom_slope = std::min(most.bottom_slope, at(bottom_slope));
        most.bottom_base = std::min(most.bottom_base, at(bottom_base));
      }
    most_[block(row, start)] = most;
  }
}

Gate OcclusionMap::gate(int row, int c, int k) const
{
  auto const at = [&](Field f) { return column(row, k, f)[c]; };
  Gate g{{at(top_slope), at(top_base), at(top_separating)},
         {at(bottom_slope), at(bottom_base), at(bottom_separating)},
         at(beyond)};
  if (g.bottom.base == -infinity) g.bottom.slope = -infinity;
  return g;
}

void OcclusionMap::set(int row, int c, int k, Gate const& g)
{
  auto const at = [&](Field f) -> float& { return column(row, k, f)[c]; };
  at(beyond) = g.beyond;
  // Slopes in a range in which products with distances do not overflow; a lower top, or a higher bottom, hides less.
  constexpr float steepest = 0x1p60F;
  at(top_slope) = std::min(g.top.slope, steepest);
  at(top_base) = g.top.base;
  at(top_separating) = g.top.separating;
  at(bottom_slope) = reaches_ground(g) ? 0 : std::max(g.bottom.slope, -steepest);  // no infinity times zero
  at(bottom_base) = g.bottom.base;
  at(bottom_separating) = g.bottom.separating;
}

bool OcclusionMap::insert(int row, int c, Gate const& gate)
{
  std::array<Gate, Options::max_components> room;
  GateList list(room.data(), 0, components_);
  for (int k = 0; k < components_; ++k) {
    Gate const g = this->gate(row, c, k);
    if (g.beyond == infinity) break;
    list.keep(g);
  }
  if (!list.add(gate)) return false;
  auto const kept = list.gates();
  for (int k = 0; k < components_; ++k)
    set(row, c, k, k < static_cast<int>(kept.size()) ? kept[static_cast<std::size_t>(k)] : empty);
  return true;
}

namespace {

/// Distances for which the products with slopes of gates, computed in floats, are on the safe side. None if they might
/// overflow.
struct Distances {
  explicit Distances(Extent const& e) : near(e.near * (1 - 0x1p-22F)), far(e.far * (1 + 0x1p-22F)) {}
  bool in_range() const { return far < 0x1p64F; }
  float near, far;
};

/// Whether a gate of these fields hides the extent. Monotone in each field, rounded as it is, so that what bounds
/// fields bounds the answer.
inline bool hides(float beyond, float top_slope, float top_base, float bottom_slope, float bottom_base,
                  Distances const& d, Extent const& e)
{
  float const top0 = top_slope * d.near, top1 = top_slope * d.far;
  float const bottom0 = bottom_slope * d.near, bottom1 = bottom_slope * d.far;
  float const top = top_base + (top0 < top1 ? top0 : top1);
  float const bottom = bottom_base + (bottom0 > bottom1 ? bottom0 : bottom1);
  return (e.near > beyond) & (top > e.high) & (bottom < e.low);
}

}  // namespace

/// Sets hidden[i] to -1 where one gate of pixel from + i hides the extent.
void OcclusionMap::hide(int row, int from, int n, Extent const& e, std::int32_t* hidden) const
{
  Distances const d(e);
  if (!d.in_range()) return;
  for (int k = 0; k < components_; ++k) {
    float const *const b = column(row, k, beyond) + from, *const ts = column(row, k, top_slope) + from,
                       *const tb = column(row, k, top_base) + from, *const bs = column(row, k, bottom_slope) + from,
                       *const bb = column(row, k, bottom_base) + from;
    for (int i = 0; i < n; ++i) hidden[i] |= -static_cast<std::int32_t>(hides(b[i], ts[i], tb[i], bs[i], bb[i], d, e));
  }
}

/// Calls visit(from, to, what of it is hidden) for each block's share of the pixels, until it returns false.
template <class Visit>
void OcclusionMap::each_block(int row, int from, int to, Extent const& e, Visit&& visit) const
{
  Distances const d(e);
  auto const hidden_by = [&](Block const& b) {
    return hides(b.beyond, b.top_slope, b.top_base, b.bottom_slope, b.bottom_base, d, e);
  };
  while (from < to) {
    int const end = std::min(to, (from / block_size + 1) * block_size);
    auto const at = block(row, from);
    auto const share = !d.in_range() || !hidden_by(most_[at]) ? Share::none
                       : hidden_by(least_[at])                ? Share::all
                                                              : Share::some;
    if (!visit(from, end, share)) return;
    from = end;
  }
}

int OcclusionMap::first_visible(int row, int from, int to, Extent const& e) const
{
  int found = to;
  each_block(row, from, to, e, [&](int start, int end, Share share) {
    if (share == Share::all) return true;
    std::array<std::int32_t, block_size> hidden{};
    if (share == Share::some) hide(row, start, end - start, e, hidden.data());
    auto const first = std::find(hidden.begin(), hidden.begin() + (end - start), 0) - hidden.begin();
    if (first == end - start) return true;
    found = start + static_cast<int>(first);
    return false;
  });
  return found;
}

bool OcclusionMap::visible_pixels(int row, int from, int to, Extent const& e, std::int32_t* open) const
{
  std::int32_t any = 0;
  each_block(row, from, to, e, [&](int start, int end, Share share) {
    auto* const here = open + (start - from);
    std::fill(here, here + (end - start), share == Share::all ? -1 : 0);
    if (share == Share::some) hide(row, start, end - start, e, here);
    for (int i = 0; i < end - start; ++i) any |= here[i] = ~here[i];
    return true;
  });
  return any != 0;
}

}  // namespace visibility::ray_space
