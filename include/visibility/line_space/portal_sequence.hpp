#pragma once

#include "visibility/kernel/point.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace visibility {

/// The question of 2.5D visibility along one sequence of edges: is there a sight line, directed from the source to the
/// target, that passes
///   - strictly below the line of the source edge (so it starts in the curtain under it),
///   - strictly below the line of the target edge (so it ends in the curtain under it),
///   - strictly above the line of every occluder edge, and
///   - in plan, with every one of `points` strictly on its side?
/// Requires for the equivalence with a line that joins the two edges: the occluders lie between source and target.
/// Weak inequalities at source and target give the same answer: a line that touches them can be lowered a little,
/// and it stays above the occluders.
/// Requires: the end points of source, target and occluders lie on their sides of every line that `points` admits,
/// most simply by being among them (`add_end_points`); otherwise above and below an edge has no meaning. Finite.
/// The order of occluders and of points, duplicates and points implied by others do not change the answer.
/// Source: [Bittner05, §5.1], [Teller92].
struct PortalSequence {
  /// The top edge of an occluder by its end points: the one left and the one right of the directed sight line in plan.
  struct Edge {
    Point3d left, right;
    friend bool operator==(Edge const&, Edge const&) = default;
  };

  enum class Side : std::uint8_t { left, right };

  /// A plan point and the side of the directed sight line on which it must lie.
  struct SidedPoint {
    Point2d point;
    Side side;
    friend bool operator==(SidedPoint const&, SidedPoint const&) = default;
  };

  /// The same for a point that had to be constructed: the crossing of two edges in plan.
  struct SidedConstructedPoint {
    Point2q point;
    Side side;
  };

  struct ConstructedEdge {
    Point3q left, right;
  };

  Edge source, target;
  std::vector<Edge> occluders{};
  std::vector<SidedPoint> points{};
  std::vector<SidedConstructedPoint> constructed_points{};
  std::optional<ConstructedEdge> constructed_target{};  ///< replaces `target`
};

/// Makes the end points of all edges of the sequence members of its `points`.
inline void add_end_points(PortalSequence& sequence)
{
  auto const add = [&](PortalSequence::Edge const& e) {
    sequence.points.push_back({horizontal(e.left), PortalSequence::Side::left});
    sequence.points.push_back({horizontal(e.right), PortalSequence::Side::right});
  };
  add(sequence.source);
  for (auto const& f : sequence.occluders) add(f);
  add(sequence.target);
}

}  // namespace visibility
