#pragma once

#include "visibility/kernel/arithmetic.hpp"
#include "visibility/methods/exact_25d/counts.hpp"
#include "visibility/methods/exact_25d/explanation.hpp"
#include "visibility/methods/exact_25d/options.hpp"
#include "visibility/scene/height_field.hpp"
#include "visibility/scene/occludees.hpp"
#include "visibility/scene/potentially_visible_set.hpp"
#include "visibility/scene/view_cell.hpp"

#include <utility>

namespace visibility {

/// Exact 2.5D visibility: which objects of a height field are visible from anywhere in a view cell, no more, no less.
/// Source: [Bittner05]; method and departures: docs/exact-2.5d.md; proof: proofs/exact_2_5d.md.
template <Arithmetic A = Filtered>
class Exact25d {
public:
  using Options = exact_25d::Options;

  Exact25d() = default;
  explicit Exact25d(Options options) : options_(options) {}

  /// The visible objects of the height field, which are those of the scene if field.raised() is 0: `exact`;
  /// `conservative` if columns reach into the cell so high that what they hide from parts of it matters; `none` with
  /// `Double`. Statistics: see exact_25d::Counts.
  PotentiallyVisibleSet operator()(HeightField const& field, ViewCell const& cell) const;
  /// The visible ones of occludees that are apart from what hides them; indices are those of the occludees' scene.
  /// Columns are occluders only. `conservative` only if columns reach the cell's top inside its outline.
  /// Source: [Bittner05, §3]; proofs/occludees.md.
  PotentiallyVisibleSet operator()(HeightField const& occluders, Occludees const& occludees,
                                   ViewCell const& cell) const;

  /// The visible objects, and why: the visible parts of all top edges, and the subdivision of line space.
  /// Parts are exact under the same conditions as the set; of an edge inside the cell's outline they are what can be
  /// seen from right above.
  std::pair<PotentiallyVisibleSet, exact_25d::Explanation> explain(HeightField const& field,
                                                                   ViewCell const& cell) const;

private:
  Options options_;
};

extern template class Exact25d<Filtered>;
extern template class Exact25d<TalliedFiltered>;
extern template class Exact25d<Rational>;
extern template class Exact25d<Double>;

}  // namespace visibility
