#pragma once

#include "visibility/raster/affine_depth.hpp"
#include "visibility/raster/span.hpp"

#include <limits>
#include <span>
#include <vector>

namespace visibility {

/// For each pixel, a depth behind which everything is hidden: the depth of the nearest occluder, or +infinity where
/// there is none [Durand00, section 2.3]. T is float or double; depths are rounded away from the viewer.
template <class T>
class DepthMap {
public:
  static constexpr T empty = std::numeric_limits<T>::infinity();

  /// All pixels empty. Throws std::invalid_argument unless 1 <= width, height <= Grid::max_size.
  DepthMap(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  T at(int x, int y) const { return depths_[index(x, y)]; }
  T const* row(int y) const { return depths_.data() + index(0, y); }
  T* row(int y) { return depths_.data() + index(0, y); }
  void clear();

  /// Takes, in each pixel of the spans, the nearer of what is stored and of an occluder's depth. Requires: spans inside
  /// the map, `depth` from above.
  void write(Spans const&, PixelDepth const& depth);
  /// The same for the farthest of several depths in each pixel: an intersection of views [Durand00, section 2.3,
  /// definition 3]. Nothing is written without depths.
  void write(Spans const&, std::span<PixelDepth const> depths);

  friend bool operator==(DepthMap const&, DepthMap const&) = default;

private:
  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_, height_;
  std::vector<T> depths_;
};

/// v rounded to T, never less than v.
template <class T>
T round_up(double v);

extern template class DepthMap<float>;
extern template class DepthMap<double>;

}  // namespace visibility
