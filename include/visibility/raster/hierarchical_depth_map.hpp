#pragma once

#include "visibility/raster/depth_map.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace visibility {

/// A depth map and its pyramid: level k halves level k - 1, rounding sizes up, and stores the farthest of the (up to)
/// four depths below [Greene93; Durand00, section 2.4]. Writing brings depths nearer and leaves the
/// pyramid as it was; queries are exact at any time, and fast after refresh().
template <class T>
class HierarchicalDepthMap {
public:
  HierarchicalDepthMap(int width, int height);
  /// Takes over a map, with its pyramid.
  explicit HierarchicalDepthMap(DepthMap<T> map);

  DepthMap<T> const& map() const { return levels_.front(); }
  int levels() const { return static_cast<int>(levels_.size()); }  ///< the last one is a single pixel
  DepthMap<T> const& level(int k) const { return levels_[static_cast<std::size_t>(k)]; }

  void clear();
  void write(Spans const&, PixelDepth const&);                   ///< as DepthMap
  void write(Spans const&, std::span<PixelDepth const> depths);  ///< as DepthMap
  /// Brings the pyramid up to date, where anything was written since it was.
  void refresh();

  /// Whether every pixel of the set stores a depth less than `nearest`: what lies there at that depth or farther is
  /// hidden. Pixels out of the map are never hidden, an empty set always is.
  bool hidden(PixelRectangle const&, T nearest) const;
  bool hidden(Spans const&, T nearest) const;
  /// The same for an occludee whose depth differs from pixel to pixel: asks the pyramid about the least
  /// depth, then pixel by pixel. Requires: a bound from below.
  bool hidden(Spans const&, PixelDepth const& below) const;

private:
  static constexpr int tile_level = 5;  // what is written is remembered by pixels of this level

  void mark(Spans const&);
  template <class Meets>
  bool hidden_below(int level, int x, int y, T nearest, Meets const& meets) const;
  template <class Meets>
  bool hidden_within(PixelRectangle const&, T nearest, Meets const& meets) const;
  void refresh_level(int level, PixelRectangle const& part);

  std::vector<DepthMap<T>> levels_;
  int tiles_wide_, tiles_high_;
  std::vector<std::uint8_t> stale_;  // one flag per tile
};

extern template class HierarchicalDepthMap<float>;
extern template class HierarchicalDepthMap<double>;

}  // namespace visibility
