#include "visibility/raster/hierarchical_depth_map.hpp"

#include <algorithm>
#include <utility>

namespace visibility {

namespace {

int half_up(int n) { return (n + 1) / 2; }

}  // namespace

template <class T>
HierarchicalDepthMap<T>::HierarchicalDepthMap(int width, int height) : HierarchicalDepthMap(DepthMap<T>(width, height))
{
}

template <class T>
HierarchicalDepthMap<T>::HierarchicalDepthMap(DepthMap<T> map)
{
  levels_.push_back(std::move(map));
  while (levels_.back().width() > 1 || levels_.back().height() > 1)
    levels_.emplace_back(half_up(levels_.back().width()), half_up(levels_.back().height()));
  constexpr int size = 1 << tile_level;
  tiles_wide_ = (this->map().width() + size - 1) / size;
  tiles_high_ = (this->map().height() + size - 1) / size;
  stale_.assign(static_cast<std::size_t>(tiles_wide_) * static_cast<std::size_t>(tiles_high_), 1);
  refresh();
}

template <class T>
void HierarchicalDepthMap<T>::clear()
{
  for (auto& level : levels_) level.clear();
  std::fill(stale_.begin(), stale_.end(), std::uint8_t{0});
}

template <class T>
void HierarchicalDepthMap<T>::write(Spans const& spans, PixelDepth const& depth)
{
  levels_[0].write(spans, depth);
  mark(spans);
}

template <class T>
void HierarchicalDepthMap<T>::write(Spans const& spans, std::span<PixelDepth const> depths)
{
  levels_[0].write(spans, depths);
  mark(spans);
}

template <class T>
void HierarchicalDepthMap<T>::mark(Spans const& spans)
{
  for (auto const& s : spans) {
    auto const row = stale_.begin() + static_cast<std::ptrdiff_t>(s.row >> tile_level) * tiles_wide_;
    std::fill(row + (s.begin >> tile_level), row + ((s.end - 1) >> tile_level) + 1, std::uint8_t{1});
  }
}

/// Recomputes pixels of a level from the level below.
template <class T>
void HierarchicalDepthMap<T>::refresh_level(int level, PixelRectangle const& part)
{
  auto& to = levels_[static_cast<std::size_t>(level)];
  auto const& from = std::as_const(levels_)[static_cast<std::size_t>(level) - 1];
  int const x1 = std::min(part.x1, to.width()), y1 = std::min(part.y1, to.height());
  int const pairs = std::min(x1, from.width() / 2);  // pixels with two columns below
  for (int y = part.y0; y < y1; ++y) {
    T const *const a = from.row(2 * y), *const b = from.row(std::min(2 * y + 1, from.height() - 1));
    T* const out = to.row(y);
    for (int x = part.x0; x < pairs; ++x) {
      T const left = a[2 * x] < b[2 * x] ? b[2 * x] : a[2 * x];
      T const right = a[2 * x + 1] < b[2 * x + 1] ? b[2 * x + 1] : a[2 * x + 1];
      out[x] = left < right ? right : left;
    }
    for (int x = std::max(part.x0, pairs); x < x1; ++x) out[x] = std::max(a[2 * x], b[2 * x]);
  }
}

template <class T>
void HierarchicalDepthMap<T>::refresh()
{
  bool any = false;
  int const below_tiles = std::min(tile_level, levels() - 1);
  for (int ty = 0; ty < tiles_high_; ++ty)
    for (int tx = 0; tx < tiles_wide_; ++tx) {
      auto& stale =
        stale_[static_cast<std::size_t>(ty) * static_cast<std::size_t>(tiles_wide_) + static_cast<std::size_t>(tx)];
      if (!stale) continue;
      stale = 0;
      any = true;
      for (int k = 1; k <= below_tiles; ++k) {
        int const size = 1 << (tile_level - k);
        refresh_level(k, {tx * size, ty * size, (tx + 1) * size, (ty + 1) * size});
      }
    }
  if (!any) return;
  for (int k = tile_level + 1; k < levels(); ++k) refresh_level(k, {0, 0, level(k).width(), level(k).height()});
}

/// Whether the part of the set under pixel (x, y) of a level is hidden. `meets` tells whether the set has a pixel under
/// a pixel of a level.
template <class T>
template <class Meets>
bool HierarchicalDepthMap<T>::hidden_below(int k, int x, int y, T nearest, Meets const& meets) const
{
  if (level(k).at(x, y) < nearest || !meets(k, x, y)) return true;
  if (k == 0) return false;
  auto const& below = level(k - 1);
  for (int v = 2 * y; v < std::min(2 * y + 2, below.height()); ++v)
    for (int u = 2 * x; u < std::min(2 * x + 2, below.width()); ++u)
      if (!hidden_below(k - 1, u, v, nearest, meets)) return false;
  return true;
}

/// The same for all pixels of the rectangle, from the finest level where it is at most two pixels wide and high, or
/// three where it straddles.
template <class T>
template <class Meets>
bool HierarchicalDepthMap<T>::hidden_within(PixelRectangle const& r, T nearest, Meets const& meets) const
{
  if (r.is_empty()) return true;
  if (r.x0 < 0 || r.y0 < 0 || r.x1 > map().width() || r.y1 > map().height()) return false;
  int k = 0;
  while ((std::max(r.x1 - r.x0, r.y1 - r.y0) - 1) >> k > 1) ++k;
  for (int y = r.y0 >> k; y <= (r.y1 - 1) >> k; ++y)
    for (int x = r.x0 >> k; x <= (r.x1 - 1) >> k; ++x)
      if (!hidden_below(k, x, y, nearest, meets)) return false;
  return true;
}

template <class T>
bool HierarchicalDepthMap<T>::hidden(PixelRectangle const& r, T nearest) const
{
  return hidden_within(r, nearest, [&](int k, int x, int y) {
    return x << k < r.x1 && (x + 1) << k > r.x0 && y << k < r.y1 && (y + 1) << k > r.y0;
  });
}

template <class T>
bool HierarchicalDepthMap<T>::hidden(Spans const& spans, T nearest) const
{
  if (spans.empty()) return true;
  PixelRectangle bounds{spans.front().begin, spans.front().row, spans.front().end, spans.back().row + 1};
  for (auto const& s : spans) {
    bounds.x0 = std::min(bounds.x0, s.begin);
    bounds.x1 = std::max(bounds.x1, s.end);
  }
  return hidden_within(bounds, nearest, [&](int k, int x, int y) {
    auto s = std::lower_bound(spans.begin(), spans.end(), y << k, [](Span const& t, int row) { return t.row < row; });
    for (; s != spans.end() && s->row < (y + 1) << k; ++s)
      if (s->begin < (x + 1) << k && s->end > x << k) return true;
    return false;
  });
}

template <class T>
bool HierarchicalDepthMap<T>::hidden(Spans const& spans, PixelDepth const& below) const
{
  if (spans.empty()) return true;
  // Rounded down to T: minus rounding minus it up.
  if (hidden(spans, -round_up<T>(-nearest(below, spans)))) return true;
  if (below.is_constant()) return false;
  for (auto const& s : spans) {
    if (s.row < 0 || s.row >= map().height() || s.begin < 0 || s.end > map().width()) return false;
    T const* const depths = map().row(s.row);
    for (int x = s.begin; x < s.end; ++x)
      if (!(depths[x] < below(x, s.row))) return false;
  }
  return true;
}

template class HierarchicalDepthMap<float>;
template class HierarchicalDepthMap<double>;

}  // namespace visibility
