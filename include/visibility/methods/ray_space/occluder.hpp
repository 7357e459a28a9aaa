#pragma once

#include "visibility/methods/ray_space/chords.hpp"
#include "visibility/methods/ray_space/footprint.hpp"
#include "visibility/methods/ray_space/gate_ends.hpp"
#include "visibility/methods/ray_space/occlusion_map.hpp"
#include "visibility/methods/ray_space/options.hpp"
#include "visibility/methods/ray_space/refined_map.hpp"

#include <utility>
#include <vector>

namespace visibility::ray_space {

/// Enters convex bodies into occlusion maps: in each pixel all of whose lines cross the body, the gate that its slices
/// hold in common. Keeps its scratch memory from body to body.
class OccluderWriter {
public:
  /// `floor`: no point of the cell and of anything that is looked for lies lower; a body that reaches it has no sight
  /// lines below.
  OccluderWriter(double floor, Options const& options) : floor_(floor), options_(options) {}

  /// Returns the number of pixels written; those in which all of `bounds`, which contains the body, is hidden are left
  /// out, since it can add nothing there. Points out of the domain of the frame make the body no occluder.
  /// `inside`: null, or a box that contains `bounds`: then the gates hold for what lies beyond it alone.
  /// `refined`: null, or the parts of the map's pixels: there the body is noted in all pixels that it touches.
  std::size_t write(Chords const& body, Box const& bounds, Frame const& frame, OcclusionMap& map,
                    RefinedMap* refined = nullptr, Box const* inside = nullptr);

private:
  /// What a chord may be used for in one row.
  struct RowChord {
    std::size_t i, j;  ///< all lines pass below point i and above point j of the plan
    bool top, bottom, ground;
    bool only_gaps;  ///< serves only where no chord before it does
  };

  /// Bounds of how far forward a chord is crossed.
  struct Crossed {
    std::vector<double> low, high;
  };

  bool localize(Chords const& body, Frame const& frame);
  std::size_t write_upright_row(Chords const& body, Frame const& frame, OcclusionMap& map, int row, int from, int to);
  void cross_upright_row(std::vector<Chord> const& chords, Frame const& frame, int row, int from, int to);
  std::size_t write_row(Chords const& body, Frame const& frame, OcclusionMap& map, int row, int from, int to);
  void cross_row(Frame const& frame, int row, RowChord const& chord, int from, int to);
  void add_chords(std::vector<Chord> const& chords, Frame const& frame, int row, int from, int to, bool only_gaps);
  bool is_gap(int column) const;
  std::pair<int, int> leave_open(LocalBox const& box, Frame const& frame, OcclusionMap const& map, int row, int from,
                                 int to);

  double floor_;
  float beyond_ = 0;  // of all gates of the body, at least
  Options options_;
  std::vector<LocalPoint> points_;
  std::vector<double> margin_;
  std::vector<bool> ground_;
  bool stands_ = false;                            // whether any point is on the ground
  std::vector<double> below_limit_, above_limit_;  // per point: lines with s up to the one pass below it, from the
                                                   // other on above
  std::vector<int> below_, above_;                 // the same in columns: [0, below) and from `above` on
  std::vector<GateEnds> ends_;                     // per column
  std::vector<std::int32_t> open_;                 // per column: not 0 where not hidden yet
  std::vector<Gate> gates_;                        // per column
  Crossed near_, far_;                             // per column
  Crossed line_[2];                                // per column line, at either slope of a row
};

}  // namespace visibility::ray_space
