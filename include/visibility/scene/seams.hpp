#pragma once

#include "visibility/kernel/point.hpp"
#include "visibility/scene/height_field.hpp"

#include <vector>

namespace visibility {

/// All pairs of tops that meet in a seam: those that have exposed parts, and perhaps others that have none. Sorted by
/// column, other, edge and side. The constructor of HeightField keeps those with parts as `seams()`.
/// Besides feet and creases across the inside of S's polygon there are those along a side of it that `edges()` leaves
/// out, because S's object goes on beyond it: nobody else asks for these.
/// Cost: one query of column_hierarchy() per column, and signs of predicates for the columns of other objects whose
/// boxes overlap with area in plan, the other one being higher somewhere.
std::vector<Seam> find_seams(HeightField const& field);

/// A box that contains the parts of the seam, up to the lower of the two tops.
/// Requires: the seam is one of find_seams(field).
Box bounds(HeightField const& field, Seam const& seam);

/// Part of a seam where S's top is exposed just in front of it and F is higher just behind. The ends lie on S's top
/// plane, named as they are seen along a sight line that runs from S's side to F's side.
struct SeamPart {
  Point3q left, right;
  friend bool operator==(SeamPart const&, SeamPart const&) = default;
};

/// The parts of a seam, of positive length and maximal, from left to right. A column G other than S covers S where G
/// has area on S's side next to the seam and its top is higher there than S's plane, or meets it all along the seam and
/// rises above it on S's side. Coinciding tops do not cover each other, curtains cover nothing, columns of the same
/// objects count. Parts may lack single points: covered intervals are closed.
/// Exact for all finite input. Laws: order -- of the columns does not matter;  split -- a column cut in two covers the
/// same.  Cost: one query of column_hierarchy(), rational numbers throughout.
/// Requires: the seam is one of find_seams(field).  Source: docs/meaning.md.
std::vector<SeamPart> exposed_parts(HeightField const& field, Seam const& seam);

}  // namespace visibility
