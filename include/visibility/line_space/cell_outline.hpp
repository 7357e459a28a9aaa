#pragma once

#include "visibility/line_space/funnel.hpp"
#include "visibility/line_space/portal_sequence.hpp"
#include "visibility/predicates/orient3d.hpp"
#include "visibility/scene/view_cell.hpp"

#include <vector>

namespace visibility {

/// The part of a view cell from which 2.5D sight lines start: the edges of its upper hull. In a vertical slice the
/// cell's top is a concave chain, and the sight line to a point outside that rises highest touches a vertex of the
/// chain. `corners` are those of the plan outline, counterclockwise, with the greatest height there; successive sides
/// may be collinear in plan. `inner` are the edges of the upper hull between two of its facets, none for a flat top.
struct CellOutline {
  std::vector<Point3d> corners;
  std::vector<PortalSequence::Edge> inner;
  double top = 0, bottom = 0;  ///< greatest and least height of the cell
  bool flat = false;           ///< all corners equally high
  Point2d centre{};
  double radius = 0;  ///< of a disc about the centre that holds the outline (rounded up)

  explicit CellOutline(ViewCell const& cell);

  std::size_t size() const { return corners.size(); }
  Point3d const& corner(std::size_t i) const { return corners[i < corners.size() ? i : i - corners.size()]; }
  /// Side i as seen along a line that goes in, or out, through it.
  PortalSequence::Edge entry(std::size_t i) const { return {corner(i), corner(i + 1)}; }
  PortalSequence::Edge exit(std::size_t i) const { return {corner(i + 1), corner(i)}; }
};

inline PlanGate gate(PortalSequence::Edge const& e) { return {horizontal(e.left), horizontal(e.right)}; }
inline Gate<RationalNumber> exact_gate(PortalSequence::Edge const& e)
{
  return {horizontal(exact(e.left)), horizontal(exact(e.right))};
}

}  // namespace visibility
