#pragma once

#include "visibility/methods/ray_space/chords.hpp"
#include "visibility/methods/ray_space/footprint.hpp"
#include "visibility/methods/ray_space/gate_ends.hpp"
#include "visibility/methods/ray_space/options.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace visibility::ray_space {

/// A point of a body in a frame.
struct BodyPoint {
  LocalPoint at;
  double margin;   ///< Frame::margin
  bool on_ground;  ///< no sight line passes below
};

/// Bodies that were entered into the map of one frame, kept so that gates for parts of its pixels can be computed.
class EnteredBodies {
public:
  struct Body {
    std::uint32_t first_point, points, first_chord, edges, others;
    bool upright;
    float beyond;  ///< of all its gates, at least
    LocalBox box;
  };

  EnteredBodies(Frame const& frame, Options const& options) : frame_(&frame), options_(options) {}

  /// Returns its number: they count from 0. One point, margin and `on_ground` for each of the chords' points.
  std::uint32_t add(Chords const& body, std::span<LocalPoint const> points, std::span<double const> margins,
                    std::vector<bool> const& on_ground, LocalBox const& box, float beyond);

  Body const& operator[](std::uint32_t body) const { return bodies_[body]; }

  /// Whether some line of the pixel may meet the body.
  bool is_touched(std::uint32_t body, Pixel const& pixel) const;

  /// The gate of the body for all lines of the pixel, if all of them cross it in front of the cell. `k`: the pixel's.
  std::optional<Gate> gate(std::uint32_t body, Pixel const& pixel, CellSlice const& k);

private:
  void add_chords(Body const& body, std::span<Chord const> chords, Pixel const& pixel, CellSlice const& k,
                  GateEnds& ends) const;

  Frame const* frame_;
  Options options_;
  std::vector<Body> bodies_;
  std::vector<BodyPoint> points_;
  std::vector<Chord> chords_;
  std::vector<bool> below_, above_;  // per point of a body: whether all lines pass on that side of it
};

}  // namespace visibility::ray_space
