#pragma once

#include "visibility/geometry/ball.hpp"
#include "visibility/geometry/convex_polyhedron.hpp"
#include "visibility/geometry/convex_prism.hpp"
#include "visibility/geometry/triangle.hpp"

#include <cstdint>
#include <vector>

namespace visibility::ray_space {

/// A segment between two points of a convex body, so inside it: where a vertical plane crosses it, the body has a
/// point.
struct Chord {
  std::uint16_t from, to;
  bool top, bottom;  ///< whether it may give the upper or the lower end of a gate that is not worse than another's
};

/// What a convex body is to vertical planes: points of it, and chords between them. Any choice is right; edges of the
/// body are best, and others serve where a vertex lies among the lines of a pixel. At most 64 points.
struct Chords {
  std::vector<Point3d> points;
  std::vector<Chord> edges, others;
  /// An upright prism: the first half of the points is its lower ring and the second half its upper one, in the same
  /// order; chords join points of the lower ring and stand for those above them as well. `top`, `bottom` do not count.
  bool upright = false;

  void clear() { points.clear(), edges.clear(), others.clear(), upright = false; }
};

/// Replaces what is in `out`.
void chords_of(Box const&, Chords& out);
void chords_of(Ball const&, Chords& out);
void chords_of(ConvexPrism const&, Chords& out);
void chords_of(ConvexPolyhedron const&, Chords& out);
void chords_of(Triangle const&, Chords& out);

}  // namespace visibility::ray_space
