#pragma once

#include "visibility/methods/ray_space/entered_bodies.hpp"
#include "visibility/methods/ray_space/gate_list.hpp"
#include "visibility/methods/ray_space/occlusion_map.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace visibility::ray_space {

/// Parts of the pixels of a map, made where a question needs them: binary trees of rectangles of lines. Each part has
/// gates of its own, of the bodies that its pixel is touched by, whether or not all lines of the pixel cross them.
class RefinedMap {
public:
  /// Requires: frame and map outlive this.
  RefinedMap(Frame const& frame, OcclusionMap& map, Options const& options);

  EnteredBodies& bodies() { return bodies_; }

  /// The body, a number of bodies(), touches the pixel and may hide something there. Bodies come in the order in which
  /// they are entered.
  void note(int row, int column, std::uint32_t body);

  /// How often bodies were noted.
  std::size_t notes() const { return notes_.size(); }

  /// A part of a pixel.
  class Part {
  public:
    Pixel const& pixel() const { return pixel_; }
    /// Whether no line of it meets the cell.
    bool is_empty() const { return is_empty_; }

  private:
    friend class RefinedMap;
    Pixel pixel_;
    // Of the whole pixel: gates that fuse must be compared with one and the same slice of the cell.
    CellSlice slice_;
    std::vector<std::uint32_t> bodies_;  // that its parts have yet to see, in order
    Reach reach_;                        // of the bodies
    std::uint32_t seen_ = 0;             // of the bodies of the part that it is a part of
    std::int32_t parts_ = -1;            // the first of its two; the other one follows
    std::int8_t gates_ = 0, halved_s_ = 0, halved_t_ = 0;
    bool is_empty_ = false;
  };

  /// The pixel as a part, up to date with the map. Requires: some line of the pixel meets the cell.
  std::uint32_t part(int row, int column);
  Part const& operator[](std::uint32_t part) const { return parts_[part]; }
  std::span<Gate const> gates(std::uint32_t part) const
  {
    return std::span(gates_).subspan(first_gate(part), static_cast<std::size_t>(parts_[part].gates_));
  }
  /// Whether what its bodies can do at best leaves the extent visible, in whatever parts: then there is no need to look
  /// at them. Rounded: a choice.
  bool is_surely_visible(std::uint32_t part, Extent const& extent) const;

  /// The first of the two halves of a part, the next number is the other; nothing if the part is as fine as any. They
  /// are to be updated before their gates are asked for. `distance`: of what is looked for, from the middle of the
  /// cell: lines then are about as far apart there in s and in t.
  std::optional<std::uint32_t> halves(std::uint32_t part, double distance);
  /// Brings one up to date with what it is a half of, which is.
  void update(std::uint32_t half, std::uint32_t whole);

  /// Gives a part the gates that its halves have in common, if it is divided.
  void raise(std::uint32_t part);
  /// Gives a pixel of the map the gates of its part. Requires: part(row, column) was asked for.
  void raise(int row, int column);

  /// How many parts there are, whole pixels counted.
  std::size_t size() const { return parts_.size(); }

private:
  std::uint32_t make_part(Pixel const& pixel, CellSlice const& slice, int halved_s, int halved_t);
  void divide(std::uint32_t part, double distance);
  std::size_t first_gate(std::uint32_t part) const { return part * static_cast<std::size_t>(options_.components); }
  GateList list(std::uint32_t part) { return {&gates_[first_gate(part)], parts_[part].gates_, options_.components}; }

  struct Root {
    std::int32_t last_note = -1, part = -1;
  };
  struct Note {
    std::uint32_t body;
    std::int32_t before;
  };
  Root& root(int row, int column)
  {
    return roots_[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame_->columns()) +
                  static_cast<std::size_t>(column)];
  }

  Frame const* frame_;
  OcclusionMap* map_;
  Options options_;
  int halvings_;
  EnteredBodies bodies_;
  std::vector<Root> roots_;
  std::vector<Note> notes_;
  std::vector<Part> parts_;
  std::vector<Gate> gates_;  // room for `components` of each part
};

}  // namespace visibility::ray_space
