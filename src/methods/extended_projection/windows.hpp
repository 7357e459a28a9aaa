#pragma once

#include "visibility/raster/depth_map.hpp"

#include <vector>

namespace visibility::extended_projection {

/// Pixels [first, last] of one axis; none if last < first.
struct Window {
  int first = 0, last = -1;
  bool is_empty() const { return last < first; }
  int size() const { return last - first + 1; }
};

/// The map whose pixel (x, y) is the farthest of the pixels of `from` in columns[x] and rows[y]; empty where one of
/// them or a window is. Requires: windows in the map, any order and sizes; columns and rows, at least one of each.
/// Cost: about two maxima a pixel if the sizes of windows differ by less than a factor of 2; rows that come out equal
/// to the one before, as where walls are upright, are copied.
DepthMap<float> farthest_in_windows(DepthMap<float> const& from, std::vector<Window> const& columns,
                                    std::vector<Window> const& rows);

}  // namespace visibility::extended_projection
