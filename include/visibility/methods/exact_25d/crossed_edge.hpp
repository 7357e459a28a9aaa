#pragma once

#include "visibility/line_space/cell_outline.hpp"
#include "visibility/scene/height_field.hpp"

namespace visibility::exact_25d {

/// An edge as sight lines cross it: from the right of a -> b (into its column), or from the left.
struct CrossedEdge {
  std::uint32_t edge;
  bool from_left;
  friend bool operator==(CrossedEdge const&, CrossedEdge const&) = default;
};

inline PortalSequence::Edge portal(HeightField::TopEdge const& e, bool from_left)
{
  return from_left ? PortalSequence::Edge{e.b, e.a} : PortalSequence::Edge{e.a, e.b};
}
inline PortalSequence::Edge portal(HeightField const& field, CrossedEdge const& c)
{
  return portal(field.edges()[c.edge], c.from_left);
}

}  // namespace visibility::exact_25d
