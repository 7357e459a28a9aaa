#include "visibility/methods/ray_space/occlusion_map.hpp"

#include "visibility/methods/ray_space/options.hpp"

#include <array>

namespace visibility::ray_space {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Where no line of a pixel meets the cell, everything is hidden.
constexpr Gate closed{{0, infinity, infinity}, open_bottom, -infinity};
constexpr Gate empty{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}, infinity};

/// How much of the view a gate blocks, for the choice of what to keep.
float size(Gate const& g)
{
  constexpr float steepest = 4;
  return std::clamp(g.top.slope, -steepest, steepest) - std::clamp(g.bottom.slope, -steepest, steepest);
}

}  // namespace

OcclusionMap::OcclusionMap(Frame const& frame, int components)
  : columns_(frame.columns()), components_(components),
    data_(static_cast<std::size_t>(frame.rows()) * static_cast<std::size_t>(components) * fields *
          static_cast<std::size_t>(columns_))
{
  for (int row = 0; row < frame.rows(); ++row)
    for (int k = 0; k < components_; ++k)
      for (int c = 0; c < columns_; ++c) set(row, c, k, frame.cell_slice(row, c) ? empty : closed);
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
  at(top_slope) = g.top.slope;
  at(top_base) = g.top.base;
  at(top_separating) = g.top.separating;
  at(bottom_slope) = reaches_ground(g) ? 0 : g.bottom.slope;  // no infinity times zero
  at(bottom_base) = g.bottom.base;
  at(bottom_separating) = g.bottom.separating;
}

void OcclusionMap::insert(int row, int c, Gate gate)
{
  std::array<Gate, Options::max_components> kept;
  int n = 0;
  for (int k = 0; k < components_; ++k) {
    Gate const g = this->gate(row, c, k);
    if (g.beyond == infinity) break;
    if (dominates(g, gate)) return;
    kept[static_cast<std::size_t>(n++)] = g;
  }
  // Fusing may make it reach another, which it did not reach before.
  for (int pass = 0; pass < n; ++pass) {
    bool changed = false;
    for (int k = 0; k < n; ++k)
      if (auto const both = fused(kept[static_cast<std::size_t>(k)], gate)) gate = *both, changed = true;
    if (!changed) break;
  }
  auto const last = std::remove_if(kept.begin(), kept.begin() + n, [&](Gate const& g) { return dominates(gate, g); });
  n = static_cast<int>(last - kept.begin());
  if (n < components_) {
    kept[static_cast<std::size_t>(n++)] = gate;
  } else {
    auto const least =
      std::min_element(kept.begin(), kept.begin() + n, [](Gate const& a, Gate const& b) { return size(a) < size(b); });
    if (size(*least) > size(gate)) return;
    *least = gate;
  }
  for (int k = 0; k < components_; ++k) set(row, c, k, k < n ? kept[static_cast<std::size_t>(k)] : empty);
}

/// Sets hidden[i] where one gate of pixel from + i hides the extent.
void OcclusionMap::hide(int row, int from, int n, Extent const& e, unsigned char* hidden) const
{
  double const near = e.near, far = e.far, low = e.low, high = e.high;
  for (int k = 0; k < components_; ++k) {
    float const *const b = column(row, k, beyond) + from, *const ts = column(row, k, top_slope) + from,
                       *const tb = column(row, k, top_base) + from, *const bs = column(row, k, bottom_slope) + from,
                       *const bb = column(row, k, bottom_base) + from;
    // Products of two floats are exact, and a sum that rounds to more than a float is more than it.
    for (int i = 0; i < n; ++i) {
      bool const behind = near > b[i];
      bool const below = (double(tb[i]) + double(ts[i]) * near > high) & (double(tb[i]) + double(ts[i]) * far > high);
      bool const above = (double(bb[i]) + double(bs[i]) * near < low) & (double(bb[i]) + double(bs[i]) * far < low);
      hidden[i] |= static_cast<unsigned char>(behind & below & above);
    }
  }
}

int OcclusionMap::first_visible(int row, int from, int to, Extent const& e) const
{
  constexpr int block = 32;
  for (int start = from; start < to; start += block) {
    int const n = std::min(block, to - start);
    std::array<unsigned char, block> hidden{};
    hide(row, start, n, e, hidden.data());
    for (int i = 0; i < n; ++i)
      if (hidden[static_cast<std::size_t>(i)] == 0) return start + i;
  }
  return to;
}

bool OcclusionMap::visible_pixels(int row, int from, int to, Extent const& e, unsigned char* open) const
{
  std::fill(open, open + (to - from), static_cast<unsigned char>(0));
  hide(row, from, to - from, e, open);
  bool any = false;
  for (int i = 0; i < to - from; ++i) any |= (open[i] ^= 1) != 0;
  return any;
}

}  // namespace visibility::ray_space
