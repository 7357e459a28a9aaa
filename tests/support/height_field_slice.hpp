#pragma once

#include "support/height_field_plan.hpp"

#include <optional>
#include <vector>

/// The vertical slice over one directed line: elementary, in rationals.
namespace visibility::oracle::detail {

/// A line's crossing of a segment; the ends of the segment lie on the line's two sides as `rising` says: from the right
/// to the left (a side by which the line leaves a counterclockwise polygon) or the other way (enters).
struct Stop {
  int segment;
  bool rising;
};

/// A point of the slice that moves with the line: where a stop's vertical carries a polygon's top plane.
struct Post {
  Stop stop;
  int top;  ///< number of the polygon
};

/// A way in which a line can see a target: the segment from `source` (an end of the cell's top) to `target` passes
/// strictly above every post of `occluders`. What is seen is a wall or fence right below its top, a top or polygon just
/// before the far end of a piece that no column covers, or a polygon just behind its near end.
struct Candidate {
  enum class Kind { wall, far_end, near_end };

  Post source, target;
  Kind kind;
  std::vector<Post> occluders;
};

/// What a line shows of a target.
struct View {
  std::vector<Candidate> candidates;
  std::optional<Witness> from_above;  ///< the target is seen for sure, inside the cell's footprint
};

/// The directed line must pass through no event of the plan whose polygons are all in `alive`; only those polygons
/// count. `shrink` > 0, small: how far from the limits a witness from above is.
View view_along(Plan const& plan, Vector const& line, int target, Polygons alive, RationalNumber const& shrink);

/// The sight line of a candidate, moved by `shrink` off its limits into the interiors of cell and face.
Witness sight_line(Plan const& plan, Vector const& line, Candidate const& candidate, RationalNumber const& shrink);

/// The stops by which the line enters and leaves the polygon, if it meets its interior; of a fence the one stop, twice.
struct Passage {
  Stop enter, leave;
};
std::optional<Passage> passage(Plan const& plan, Vector const& line, int polygon);

}  // namespace visibility::oracle::detail
