#pragma once

#include "visibility/methods/ray_space/chords.hpp"
#include "visibility/methods/ray_space/footprint.hpp"
#include "visibility/methods/ray_space/gate_ends.hpp"
#include "visibility/methods/ray_space/options.hpp"
#include "visibility/methods/ray_space/reach.hpp"

#include <array>
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
    bool upright, on_ground;  ///< as Chords::upright; whether any point is on the ground
    float beyond;             ///< of all its gates, at least
    LocalBox box;
  };

  EnteredBodies(Frame const& frame, Options const& options) : frame_(&frame), options_(options) {}

  /// Returns its number: they count from 0. One point, margin and `on_ground` for each of the chords' points.
  std::uint32_t add(Chords const& body, std::span<LocalPoint const> points, std::span<double const> margins,
                    std::vector<bool> const& on_ground, LocalBox const& box, float beyond);

  Body const& operator[](std::uint32_t body) const { return bodies_[body]; }

  /// How the lines of a pixel pass a body: a bit for each of its points in plan, set if all of them pass below it, or
  /// above.
  struct Passing {
    std::uint64_t below, above;
    bool some_meet;  ///< unless no line meets the body
    bool all_meet() const { return below != 0 && above != 0; }
  };
  Passing passing(std::uint32_t body, Pixel const& pixel) const;

  /// How far at best the body reaches, wherever in its box it is. `k`: of the pixel.
  Reach reach(std::uint32_t body, CellSlice const& k) const;

  /// The gate of the body for all lines of the pixel; nothing unless they all cross it in front of the cell, in common
  /// chords. `passing`: of the body and the pixel; `k`: the slice of the cell that gates it may fuse with are of.
  std::optional<Gate> gate(std::uint32_t body, Passing const& passing, Pixel const& pixel, CellSlice const& k) const;

private:
  std::array<SlicePoint, 4> corners(BodyPoint const& p, BodyPoint const& q, Pixel const& pixel) const;
  GateEnds ends(Body const& body, Passing const& passing, Pixel const& pixel, CellSlice const& k) const;
  GateEnds upright_ends(Body const& body, Passing const& passing, Pixel const& pixel, CellSlice const& k) const;
  template <class Take>
  void each_chord(Body const& body, std::span<Chord const> chords, Passing const& passing, Pixel const& pixel,
                  CellSlice const& k, Take&& take) const;

  Frame const* frame_;
  Options options_;
  std::vector<Body> bodies_;
  std::vector<BodyPoint> points_;
  std::vector<Chord> chords_;
};

}  // namespace visibility::ray_space
