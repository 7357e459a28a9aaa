#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace visibility::extended_projection {

/// How the sweep takes over what a plane knows on the next one [Durand00, 5.1].
enum class Reprojection {
  windows,     ///< each column and row of pixels looks through a window of its own: the tighter one
  convolution  ///< the paper's: one kernel, the image of an equivalent flat cell, which contains the cell's views
};

/// Along what the planes of a cell stand that is a box in any position [Durand00, 2.4]; of all other cells they stand
/// along the axes.
enum class Directions {
  automatic,  ///< what has smaller sets: the sides of upright cells, otherwise the axes
  cell,
  axes
};

/// The Depth of a convex part [Durand00, 2.3, definition 3].
enum class PartDepth {
  part,  ///< one number for each part: its farthest point
  pixel  ///< where it is nearer, a bound that is affine over the plane
};

/// All of these are choices: the set is conservative whatever they are.
struct Options {
  int resolution = 256;          ///< depth maps have as many pixels as its square; 1 to Grid::max_size
  double extent = 1.5;           ///< a plane at distance d reaches extent * d beyond the cell's sides [Durand00, 6.1]
  int planes = 0;                ///< in each of the six directions, at most; 0: 8, or 15 for a sweep
  std::size_t occluders = 1000;  ///< convex bodies of the largest solid angle that are projected for a cell
  bool more_occluders = true;    ///< then those of objects that are still visible, too [Durand00, 6.1]
  bool improved = true;          ///< the repaired improved Projection of occludees [Durand00, 4]
  bool slices = true;            ///< sections of closed meshes with the planes [Durand00, 3.3]
  PartDepth depth = PartDepth::part;
  double kernel = 5;  ///< of a sweep: planes are so far apart that the cell's image is this many pixels [Durand00, 5.2]
  Directions directions = Directions::automatic;
  Reprojection reprojection = Reprojection::windows;  ///< of a sweep
  /// Of extended projections: one plane in each direction, so far off that each pixel is a direction: the fuzzy
  /// projection of [Lim92] as [Durand00, 7.4] describes it, for comparison.
  bool infinity = false;
  /// Distances of the planes from the cell, in place of chosen ones; each > 0, in metres.
  std::vector<double> distances{};

  /// Throws std::invalid_argument, with the reason in one line.
  void validate() const
  {
    if (resolution < 1 || resolution > 4096) throw std::invalid_argument("resolution must be 1 to 4096");
    if (!(extent > 0 && extent <= 1e6)) throw std::invalid_argument("extent must be positive, and at most 10^6");
    if (planes < 0 || planes > 1000) throw std::invalid_argument("planes must be 1 to 1000, or 0 for the default");
    if (!(kernel > 1 && kernel <= 1000)) throw std::invalid_argument("kernel must be above 1, and at most 1000");
    for (double const d : distances)
      if (!(d > 0 && d < 1e300)) throw std::invalid_argument("plane distances must be positive and finite");
  }
};

}  // namespace visibility::extended_projection
