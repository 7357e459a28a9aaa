#pragma once

#include "visibility/methods/ray_space/frame.hpp"
#include "visibility/methods/ray_space/reach.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace visibility::ray_space {

/// A part of a slice: all within [near, far] from the back of the frame and [low, high] in height. Bounds rounded
/// outward.
struct Extent {
  float near, far, low, high;
};

/// For each pixel of a frame up to a fixed number of gates that hold for all its lines. [Leyvand03, section 4]
class OcclusionMap {
public:
  OcclusionMap(Frame const& frame, int components);

  /// Adds gates to the pixels from a column on, one to each; one that hides nothing has beyond = infinity. Each is
  /// fused with those that are there where no gap is left, and the largest are kept, the largest of all first.
  void insert(int row, int from, std::span<Gate const> gates);

  /// The first of the pixels [from, to) of the row in which no single gate hides the extent; `to` if there is none.
  int first_visible(int row, int from, int to, Extent const& extent) const;

  /// The same for all of the pixels: open[i - from] is 0 where one gate hides the extent, and -1 elsewhere. Returns
  /// whether any is not.
  bool visible_pixels(int row, int from, int to, Extent const& extent, std::int32_t* open) const;

  /// Whether the largest gate of the pixel reaches as far.
  bool reaches(int row, int c, Reach const& reach) const
  {
    auto const at = [&](Field f) { return column(row, 0, f)[c]; };
    // A stored gate keeps an open bottom in the height of its line.
    float const bottom = at(bottom_base) == open_bottom.base ? open_bottom.slope : at(bottom_slope);
    return ray_space::reaches(Gate{{at(top_slope), 0, 0}, {bottom, 0, 0}, at(beyond)}, reach);
  }

  int components() const { return components_; }
  /// A gate of a pixel; one that hides nothing has beyond = infinity.
  Gate gate(int row, int column, int component) const;

private:
  // Of a row, per component: columns of floats, one for each of these.
  enum Field { beyond, top_slope, top_base, bottom_slope, bottom_base, top_separating, bottom_separating, fields };
  float const* column(int row, int component, Field f) const
  {
    return &data_[((static_cast<std::size_t>(row) * static_cast<std::size_t>(components_) +
                    static_cast<std::size_t>(component)) *
                     fields +
                   f) *
                  static_cast<std::size_t>(columns_)];
  }
  float* column(int row, int component, Field f)
  {
    return const_cast<float*>(static_cast<OcclusionMap const*>(this)->column(row, component, f));
  }
  /// Bounds, field by field, of the gates of a block of pixels of a row: a pyramid of one level above the pixels.
  struct Block {
    float beyond, top_slope, top_base, bottom_slope, bottom_base;
  };
  static constexpr int block_size = 16;
  std::size_t block(int row, int column) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>((columns_ + block_size - 1) / block_size) +
           static_cast<std::size_t>(column / block_size);
  }
  enum class Share { none, some, all };
  template <class Visit>
  void each_block(int row, int from, int to, Extent const& extent, Visit&& visit) const;
  bool insert(int row, int column, Gate const& gate);  // whether anything changed
  void update_blocks(int row, int from, int to);
  void hide(int row, int from, int n, Extent const& extent, std::int32_t* hidden) const;
  void set(int row, int column, int component, Gate const& gate);

  int columns_, components_;
  std::vector<float> data_;
  std::vector<Block> least_;  // what hides less than the first gate of every pixel
  std::vector<Block> most_;   // what hides more than any gate of any pixel
};

}  // namespace visibility::ray_space
